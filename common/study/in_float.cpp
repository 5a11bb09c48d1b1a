#include "common/study/running.hpp"

namespace breakshot::study {

template std::unique_ptr<Running> running_in<float>(const Method&, const Input&);

}  // namespace breakshot::study
