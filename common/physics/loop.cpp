// The loops are compiled apart from those that choose between them: in one translation unit they
// would keep one another from being inlined, for two percent of the instructions of a break.
#include "common/physics/simulation.hpp"

namespace breakshot::physics {

template class Loop<double, TableCalendar>;

}  // namespace breakshot::physics
