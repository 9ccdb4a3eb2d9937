// How long tests wait for what comes soon on an idle machine.
#pragma once

namespace hairpaint::test {

inline constexpr int kPatienceMs = 60'000;

} // namespace hairpaint::test
