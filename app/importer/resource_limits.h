// Bounds on what the helper may use, whatever the file it reads.
#pragma once

#include <cstdint>

namespace hairpaint::importer {

/// Call first. Memory about 1.8 GB; where the system can't bound it, the editor's timeout remains.
void limitResources();

/// The current memory limit, in MB; 0 if there is none.
[[nodiscard]] std::uint32_t mostMegabytes();

} // namespace hairpaint::importer
