// What stands for Embree where it is not installed?
#include "peers.h"

namespace halfdisk {

std::unique_ptr<Peer> makeEmbree(const Scene&, Extrusion) {
    return nullptr;
}

}  // namespace halfdisk
