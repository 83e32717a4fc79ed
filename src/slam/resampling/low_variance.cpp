// Low variance [T table 6.2], elsewhere called systematic (Kitagawa, 1996): one draw for all.

#include "cumulated_weights.hpp"
#include "methods.hpp"

namespace hitos {

void low_variance_selection(std::span<const double> weights, double start,
                            std::vector<std::uint32_t>& selected) {
    const std::size_t count = weights.size();
    selected.resize(count);
    const double spacing = 1.0 / static_cast<double>(count);
    const auto weight = [&](std::size_t i) { return weights[i]; };
    CumulatedWeights walk(count, weight);
    for (std::size_t m = 0; m < count; ++m) {
        selected[m] = walk.at((start + static_cast<double>(m)) * spacing);
    }
}

namespace {

class LowVariance final : public ResamplingMethod {
  public:
    void select(std::span<const double> weights, RandomStream& random,
                std::vector<std::uint32_t>& selected) const override {
        low_variance_selection(weights, random.uniform(), selected);
    }
};

}  // namespace

ResamplingMethodEntry low_variance_resampling() {
    ResamplingMethodEntry entry;
    entry.word = "low-variance";
    entry.label = HITOS_TEXT("ParameterChoice", "Low variance");
    entry.purpose = "one draw for all particles at equal distances; the fewest random differences";
    entry.make = [](const ResamplingParams&) { return std::make_unique<LowVariance>(); };
    return entry;
}

}  // namespace hitos
