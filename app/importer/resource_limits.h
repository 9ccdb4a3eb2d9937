// Bounds on what the helper may use, whatever the file it reads.
#pragma once

namespace hairpaint::importer {

/// Call first. Memory about 1.8 GB; where the system can't bound it, the editor's timeout remains.
void limitResources();

} // namespace hairpaint::importer
