// What stands for Box2D where it is not installed?
#include "peers.h"

namespace halfdisk {

std::unique_ptr<Peer> makeBox2D(const Scene&) {
    return nullptr;
}

}  // namespace halfdisk
