#include "common/study/running.hpp"

namespace breakshot::study {

template std::unique_ptr<Running> running_in<double>(const Method&, const Input&);

}  // namespace breakshot::study
