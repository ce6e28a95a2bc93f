#pragma once
#include <string>
#include <vector>

#include "report/html/command_report.hpp"
#include "report/html/page_elements.hpp"

namespace percuss::report {

/// A command's report as a self-contained page: its text, its charts, and its provenance from the files `inputs`.
std::string command_page(const CommandReport& report, const std::vector<std::string>& inputs,
                         const Provenance& provenance);

}  // namespace percuss::report
