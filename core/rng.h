// Where does a random number come from? From its address: (seed, node of the recursion, sample, dimension).
//
// Counter-based generation (Salmon et al. 2011, "Parallel random numbers: as easy as 1, 2, 3"): no state is
// carried from one draw to the next, so the same seed gives the same bits in any order and on any number of
// threads.
#pragma once

#include <Random123/philox.h>

#include <cstdint>

#include "philox_row.h"

namespace halfdisk {

/// The random numbers of one node of the recursion tree. Copy it freely; it has no state.
class Rng {
 public:
    /// Root node of one repeat of an experiment.
    Rng(std::uint64_t seed, std::uint64_t repeat) : seed_(seed), node_(mixed(repeat)) {}

    /// The node below this one that sample n leads to.
    Rng child(std::uint32_t n) const {
        Rng below = *this;
        below.node_ = mixed(node_ + (n + std::uint64_t{1}) * 0xD1342543DE82EF95u);
        return below;
    }

    /// Uniform in the open interval (0, 1): never an end, so that acos, log and 1/x stay finite. 52 random
    /// bits.
    double uniform(std::uint32_t sample, std::uint32_t dimension) const {
        r123::Philox4x32::ctr_type counter = {{low(node_), high(node_), sample, dimension / 2}};
        r123::Philox4x32::key_type key = {{low(seed_), high(seed_)}};
        const auto block = r123::Philox4x32()(counter, key);
        const unsigned half = 2 * (dimension % 2);
        const std::uint64_t bits = (std::uint64_t{block[half]} << 32) | block[half + 1];
        return (static_cast<double>(bits >> 12) + 0.5) * 0x1p-52;
    }

    /// uniform(first + i, dimension) for i = 0 ... 3, in hardly more time than one.
    std::array<double, 4> uniforms(std::uint32_t first, std::uint32_t dimension) const {
        return philoxRow({low(seed_), high(seed_)}, node_, first, dimension / 2, dimension % 2);
    }

 private:
    static std::uint32_t low(std::uint64_t x) { return static_cast<std::uint32_t>(x); }
    static std::uint32_t high(std::uint64_t x) { return static_cast<std::uint32_t>(x >> 32); }

    // A bijection of 64 bits in which every input bit flips every output bit with chance one half (the
    // finaliser of Steele et al. 2014, "Fast splittable pseudorandom number generators").
    static std::uint64_t mixed(std::uint64_t x) {
        x += 0x9E3779B97F4A7C15u;
        x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
        x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
        return x ^ (x >> 31);
    }

    std::uint64_t seed_;
    std::uint64_t node_;
};

/// One dimension of a node's random numbers, for samples that are asked for one after the other.
class UniformRow {
 public:
    UniformRow(const Rng& rng, std::uint32_t dimension) : rng_(rng), dimension_(dimension) {}

    /// rng.uniform(sample, dimension).
    double operator()(std::uint32_t sample) {
        const std::uint32_t first = sample & ~3u;
        if (first != first_) values_ = rng_.uniforms(first_ = first, dimension_);
        return values_[sample - first];
    }

    const Rng& rng() const { return rng_; }

 private:
    const Rng& rng_;
    std::uint32_t dimension_;
    std::uint32_t first_ = 1;  // of the four that are known: none yet
    std::array<double, 4> values_;
};

}  // namespace halfdisk
