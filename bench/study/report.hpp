// The study's page: its tables and plots, all from the CSV files, so that they can be made again.
#pragma once

#include <string>

#include "bench/study/measure.hpp"

namespace breakshot::bench {

/// `page` with every table between `<!-- table NAME -->` and `<!-- end -->` made from the files; a
/// name that there is no table for is an exception.
std::string filled(const std::string& page, const StudyFiles& files);

/// A gnuplot script that draws accuracy.png and growth.png into the folder it is run in.
std::string plots(const StudyFiles& files);

}  // namespace breakshot::bench
