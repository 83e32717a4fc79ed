// Stratified (Kitagawa, 1996, "Monte Carlo filter and smoother"): one draw in each M-th part.

#include "cumulated_weights.hpp"
#include "methods.hpp"

namespace hitos {
namespace {

class Stratified final : public ResamplingMethod {
  public:
    void select(std::span<const double> weights, RandomStream& random,
                std::vector<std::uint32_t>& selected) const override {
        const std::size_t count = weights.size();
        selected.resize(count);
        const double spacing = 1.0 / static_cast<double>(count);
        const auto weight = [&](std::size_t i) { return weights[i]; };
        CumulatedWeights walk(count, weight);
        for (std::size_t m = 0; m < count; ++m) {
            selected[m] = walk.at((random.uniform() + static_cast<double>(m)) * spacing);
        }
    }
};

}  // namespace

ResamplingMethodEntry stratified_resampling() {
    ResamplingMethodEntry entry;
    entry.word = "stratified";
    entry.label = HITOS_TEXT("ParameterChoice", "Stratified");
    entry.purpose = "one draw for each M-th part of the weights";
    entry.make = [](const ResamplingParams&) { return std::make_unique<Stratified>(); };
    return entry;
}

}  // namespace hitos
