// Heads from archives and into them.
#include "model/files/head_entry.h"

#include "model/files/head_file.h"

namespace hairpaint::model {

namespace {

constexpr qint64 kMostHeadBytes = 256 << 20;

} // namespace

Checked<std::shared_ptr<const Head>> readHead(const ArchiveReader& archive, const HeadReference& reference,
                                              const std::function<bool()>& goesOn)
{
    if (reference.builtIn)
        return builtInHead(reference.name);
    const Checked<QByteArray> glb = archive.read(QStringLiteral("head.glb"), kMostHeadBytes);
    if (!glb)
        return tl::unexpected(glb.error());
    return headFromGlb(reference.name, *glb, reference.unitScale, reference.upAxis, goesOn, reference.landmarks);
}

void addHead(ArchiveWriter& archive, const std::shared_ptr<const Head>& head)
{
    if (head && !head->builtIn)
        archive.add("head.glb", head->sourceGlb, ArchiveWriter::Method::Deflated);
}

} // namespace hairpaint::model
