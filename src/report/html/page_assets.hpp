#pragma once
#include <string_view>

namespace percuss::report {

/// The parts of every page: page/page.css and page/page.js, and uPlot's (third_party/uplot).
struct PageAssets {
  std::string_view style, program, plot_style, plot_program;
};
const PageAssets& page_assets();

}  // namespace percuss::report
