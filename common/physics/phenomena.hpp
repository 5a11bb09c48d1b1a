// Whether the engine has spin, friction of contacts, and jaws at all. Every build has; one without
// is made only to measure what their presence costs the scenes that do not list them
// (bench/count_breaks.cpp): such scenes have the same bits in both.
#pragma once

namespace breakshot::physics {

#ifdef BREAKSHOT_PLAIN_ENGINE
inline constexpr bool plain_engine = true;
#else
inline constexpr bool plain_engine = false;
#endif

}  // namespace breakshot::physics
