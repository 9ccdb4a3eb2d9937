// One start of the helper for many requests, without what one of them leaves behind reaching the next.
#pragma once

#include <functional>

namespace hairpaint::importer {

/// Has `serve` called for each request that comes on standard input, until that ends, and returns the exit code: 0, or
/// that of the first request that was not served. `serve` reads the request, answers it and returns 0, or another code
/// where it can't.
///
/// On Unix each request has a process of its own, forked from this one, which has loaded the libraries and read
/// nothing: limits are each request's own, and a decoder that a file has taken over is gone before the next request is
/// told of. wire::kServed on standard error tells the editor that; the fork can't, since its own standard error leads
/// nowhere. It is also the only thread of its process, so that what confines a thread confines all of it. Where there
/// is no fork (Windows, or no more processes), one request is served here, and that is all.
[[nodiscard]] int serveEach(const std::function<int()>& serve);

} // namespace hairpaint::importer
