// Whichever call to the disk fails, and whichever large piece of memory is refused, while maps are exported: all are
// there and whole, or the folder is as it was.
#include "model/exporting/map_images.h"
#include "tests/model/each_fault.h"
#include "tests/support/allocation_limit.h"
#include "tests/support/file_faults.h"
#include "tests/support/locations.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace hairpaint;
using namespace hairpaint::model;

namespace {

constexpr std::size_t kLargeBytes = 32 << 10;

/// Two maps; the second one's file is there before. Faults come to this process alone.
template<typename Fault, typename... Options>
QString mapsUnderEach(const QString& suffix, Options... options)
{
    constexpr int kSize = 256;
    const MapImageOptions image{.format = findMapImageFormat(suffix)};
    std::vector<WantedMap> maps;
    for (const MapKind kind : {MapKind::Length, MapKind::Colour})
        maps.push_back({.group = QStringLiteral("Scalp"),
                        .kind = kind,
                        .resolved = std::make_shared<sim::TiledRaster>(kSize, mapSpec(kind).valueChannels,
                                                                       sim::Texel{30'000, 20'000, 10'000})});
    test::FaultyFolder folder;
    return folder.underEach<Fault>(
        {folder.filePath(mapImageNames(maps, image)[1])}, [&] { return writeMapImages(maps, folder.path(), image); },
        options...);
}

} // namespace

class TestMapFaults : public QObject
{
    Q_OBJECT
private:
    static void someFormats()
    {
        QTest::addColumn<QString>("suffix");
        for (const char* suffix : {"png", "tga"}) // The others hold the time of their making.
            QTest::newRow(suffix) << QString::fromLatin1(suffix);
    }

private Q_SLOTS:
    /// The real helper takes a tenth of a second to start, hundreds of times; here it is only asked for bytes.
    void initTestCase()
    {
        qputenv("HAIRPAINT_IMPORT", test::fakeHelper().toLocal8Bit());
        qputenv("HAIRPAINT_FAKE_HELPER", "unencoded");
    }

#ifdef Q_OS_LINUX
    void mapsAreExportedOrTheOldFilesAreThere_data()
    {
        someFormats();
    }
    void mapsAreExportedOrTheOldFilesAreThere()
    {
        QFETCH(QString, suffix);
        QCOMPARE(mapsUnderEach<test::FileFault>(suffix), QString());
    }
#endif

    void whereMemoryIsRefusedMapsAreExportedOrTheOldFilesAreThere_data()
    {
        someFormats();
    }
    void whereMemoryIsRefusedMapsAreExportedOrTheOldFilesAreThere()
    {
        QFETCH(QString, suffix);
        QCOMPARE(mapsUnderEach<test::AllocationFault>(suffix, kLargeBytes), QString());
    }
};

HAIRPAINT_TEST(TestMapFaults, Gui)
#include "test_map_faults.moc"
