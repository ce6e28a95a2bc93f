#pragma once
#include <string_view>

namespace percuss::report {

/// The style sheet and the scripts of every page (html/page), and of uPlot (third_party/uplot).
struct PageAssets {
  std::string_view style, program, plot_style, plot_program;
};
const PageAssets& page_assets();

}  // namespace percuss::report
