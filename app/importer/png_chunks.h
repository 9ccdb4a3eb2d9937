// The chunks of a PNG file in memory.
#pragma once

#include <vector>

namespace hairpaint::importer {

/// Takes every eXIf chunk out: OpenImageIO 2.5 writes an empty one twice, where PNG allows one, and 2.4 writes none.
/// What is no PNG file, or is cut short, stays as it is. Any thread.
void dropExif(std::vector<unsigned char>& png);

} // namespace hairpaint::importer
