#pragma once

#include <string>

namespace cairn_test {
extern std::string own_program; // path of this program
}
