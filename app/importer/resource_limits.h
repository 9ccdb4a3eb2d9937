// Bounds on what the helper may use, whatever the file it reads.
#pragma once

#include <cstdint>

namespace hairpaint::importer {

/// Call first. Memory about 1.8 GB; where the system can't bound it, the editor's timeout remains.
void limitResources();

/// That bound as it holds now, in MB; 0 where there is none.
[[nodiscard]] std::uint32_t mostMegabytes();

} // namespace hairpaint::importer
