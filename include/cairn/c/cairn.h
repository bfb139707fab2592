// Made by tools/api.py from api/: change those, and run it.
// clang-format off
/// \file cairn.h
/// The C API. C programs may include <cairn/cairn.h> as well.
#ifndef CAIRN_C_CAIRN_H
#define CAIRN_C_CAIRN_H

#include <cairn/c/base.h>
#include <cairn/c/math.h>
#include <cairn/c/shape.h>
#include <cairn/c/body.h>
#include <cairn/c/joint.h>
#include <cairn/c/query.h>
#include <cairn/c/events.h>
#include <cairn/c/world.h>
#include <cairn/c/scene.h>

#endif // CAIRN_C_CAIRN_H
