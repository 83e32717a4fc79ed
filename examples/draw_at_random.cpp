// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers drawn at random that have addresses: the same wherever, whenever and by whatever thread
// they are drawn; and a digest that tells them from others.
//
// usage: draw_at_random SEED
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "hitos/base/digest.hpp"
#include "hitos/base/random_stream.hpp"

int main(int argc, char** argv) {
    const std::uint64_t seed = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1;
    // The noise of particle 5 at step 17: nothing has to be drawn before it.
    hitos::RandomStream noise(seed, hitos::RandomPurpose::motion, 17, 5);
    std::string bytes;
    for (int i = 0; i < 3; ++i) {
        const auto [one, other] = noise.normal_pair();
        std::printf("%.17g %.17g\n", one, other);
        bytes.append(reinterpret_cast<const char*>(&one), sizeof one);
        bytes.append(reinterpret_cast<const char*>(&other), sizeof other);
    }
    std::printf("digest %s\n", hitos::Digest().add(bytes).text().c_str());
}
