// How are millions of things kept as they come? In blocks, so that none has to be moved when there are more:
// that alone would take longer than whoever calls the work off is ready to wait.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "stop.h"

namespace halfdisk {

template <class Thing>
class Blocks {
 public:
    void push_back(const Thing& thing) {
        if (size_ == blocks_.size() * kBlock)
            blocks_.push_back(std::make_unique_for_overwrite<Thing[]>(kBlock));
        blocks_.back()[size_++ % kBlock] = thing;
    }

    std::size_t size() const { return size_; }

    /// All in one row, for which the blocks are given up. Throws Stopped if `stop` says so.
    std::vector<Thing> joined(const StopQuestion& stop) && {
        std::vector<Thing> all;
        all.reserve(size_);
        for (auto& block : blocks_) {
            throwIfStopped(stop);
            all.insert(all.end(), block.get(), block.get() + std::min(kBlock, size_ - all.size()));
            block.reset();
        }
        blocks_.clear();
        size_ = 0;
        return all;
    }

 private:
    static constexpr std::size_t kBlock = 1024;

    std::vector<std::unique_ptr<Thing[]>> blocks_;
    std::size_t size_ = 0;
};

}  // namespace halfdisk
