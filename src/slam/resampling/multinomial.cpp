// Multinomial (Gordon, Salmond and Smith, 1993): M independent draws.

#include "cumulated_weights.hpp"
#include "methods.hpp"

namespace hitos {
namespace {

class Multinomial final : public ResamplingMethod {
  public:
    void select(std::span<const double> weights, RandomStream& random,
                std::vector<std::uint32_t>& selected) const override {
        const std::size_t count = weights.size();
        selected.resize(count);
        const auto weight = [&](std::size_t i) { return weights[i]; };
        CumulatedWeights walk(count, weight);
        AscendingDraws draws(count, random);
        for (std::uint32_t& particle : selected) particle = walk.at(draws.next());
    }
};

}  // namespace

ResamplingMethodEntry multinomial_resampling() {
    ResamplingMethodEntry entry;
    entry.word = "multinomial";
    entry.label = HITOS_TEXT("ParameterChoice", "Multinomial");
    entry.purpose = "every particle drawn by itself; the most random differences, for comparison";
    entry.make = [](const ResamplingParams&) { return std::make_unique<Multinomial>(); };
    return entry;
}

}  // namespace hitos
