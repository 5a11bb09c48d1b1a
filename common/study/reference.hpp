// The scalar that errors are measured against: 50 decimal digits. Its exponent has the range of
// IEEE 754's binary128, so that what the physics derives from the range stays small.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cstdint>
#include <limits>

#include "common/physics/cloth.hpp"

namespace breakshot::study {

/// Every operation is rounded to nearest, so that the arithmetic of exact.hpp holds for it too.
/// Without expression templates: the physics deduces types from what operators return.
using Reference = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<50, boost::multiprecision::digit_base_10, void,
                                         std::int16_t, -16382, 16383>,
    boost::multiprecision::et_off>;

}  // namespace breakshot::study

namespace breakshot::physics {

/// What is a constant for the compiler's own scalars cannot be one for a class.
template <>
inline const study::Reference never<study::Reference> =
    std::numeric_limits<study::Reference>::infinity();

}  // namespace breakshot::physics
