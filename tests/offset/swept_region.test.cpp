// SPDX-License-Identifier: MIT

#include <typemesh/offset/swept_region.hpp>

#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("clear() empties a swept region completely and keeps its storage", "[swept_region]")
{
    swept_region s;
    REQUIRE((s.nodes.push_back({}) && s.cells.push_back({}) && s.triangles.push_back({}) && s.levels.push_back(1.0)));
    REQUIRE((s.edges_at.push_back({}) && s.at_level.push_back(1) && s.joins.push_back({})));
    REQUIRE((s.cap.points.push_back({}) && s.cap_nodes.push_back(1)));
    s.first_loss = 3.0;
    s.lost = 2;
    s.events = 2;
    s.schedules = 3;
    const swept_node* storage = s.nodes.data();
    s.clear();
    CHECK((s.nodes.empty() && s.cells.empty() && s.triangles.empty() && s.levels.empty()));
    CHECK((s.edges_at.empty() && s.at_level.empty() && s.joins.empty()));
    CHECK((s.cap.points.empty() && s.cap_nodes.empty()));
    CHECK((s.first_loss < 0.0 && s.lost == 0 && s.events == 0 && s.schedules == 0));
    CHECK(s.nodes.data() == storage);
}
