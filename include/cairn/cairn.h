/// \file cairn.h
/// The whole public API.
#pragma once

#include <cairn/body.h>
#include <cairn/error.h>
#include <cairn/events.h>
#include <cairn/handle.h>
#include <cairn/joint.h>
#include <cairn/math.h>
#include <cairn/query.h>
#include <cairn/shape.h>
#include <cairn/snapshot.h>
#include <cairn/triangles.h>
#include <cairn/version.h>
#include <cairn/world.h>
