// SPDX-License-Identifier: MIT
#pragma once

// A shape whose cap a refiner has refined.

#include "support/filled_shape.hpp"
#include "support/refined_cap.hpp"

#include <typemesh/triangulate/constrained_delaunay.hpp>
#include <typemesh/triangulate/monotone.hpp>
