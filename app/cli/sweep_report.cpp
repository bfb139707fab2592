#include "cli/sweep_results.h"

namespace cairn::cli {

std::string sweep_report(const sweep::Plan&, const sweep::Summary&, const std::vector<std::string>&) { return {}; }

} // namespace cairn::cli
