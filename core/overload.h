// How is a variant visited by one lambda for each case?
#pragma once

namespace halfdisk {

template <class... Cases>
struct Overload : Cases... {
    using Cases::operator()...;
};
template <class... Cases>
Overload(Cases...) -> Overload<Cases...>;

}  // namespace halfdisk
