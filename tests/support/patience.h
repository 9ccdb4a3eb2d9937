// How long tests wait for what comes soon on an idle machine.
#pragma once

namespace hairpaint::test {

#if defined(HAIRPAINT_ASAN) || defined(HAIRPAINT_TSAN)
inline constexpr int kPatienceMs = 180'000; ///< Five to ten times slower, and another program beside it.
#else
inline constexpr int kPatienceMs = 60'000;
#endif

} // namespace hairpaint::test
