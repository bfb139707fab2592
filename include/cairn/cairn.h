/// \file cairn.h
/// The whole public API of C++. Included from a C program, it gives the C API (cairn/c/cairn.h).
#pragma once

#ifdef __cplusplus

#include <cairn/body.h>
#include <cairn/commands.h>
#include <cairn/communicator.h>
#include <cairn/error.h>
#include <cairn/events.h>
#include <cairn/handle.h>
#include <cairn/history.h>
#include <cairn/joint.h>
#include <cairn/math.h>
#include <cairn/query.h>
#include <cairn/shape.h>
#include <cairn/snapshot.h>
#include <cairn/snapshot_ring.h>
#include <cairn/triangles.h>
#include <cairn/version.h>
#include <cairn/world.h>
#include <cairn/world_pool.h>

#else

#include <cairn/c/cairn.h>

#endif
