// Copy, cut, clear and paste, inside a map and between maps.
#include "model/maps/compositor.h"
#include "model/tools/selecting/clipboard.h"
#include "tests/model/fixtures.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cstdlib>

using namespace hairpaint;
using namespace hairpaint::model;
using namespace hairpaint::test;

namespace {

/// A project with a value in the texels 64..96 x 64..80 of one map.
Project projectWith(MapKind map, const sim::Texel& texel)
{
    Project project = patchProject();
    for (int y = 64; y < 80; ++y)
        for (int x = 64; x < 96; ++x)
            project.groups.front().map(map).layers.front().raster.setTexel(x, y, texel);
    return project;
}

const QRectF kThere(0.25, 1.0 - 80.0 / 256.0, 0.125, 0.0625); // Those texels.

const sim::TiledRaster& rasterOf(const Document& document, MapKind map)
{
    const LayerAddress at = firstLayer(document, map);
    return document.project().layer(at.group, at.map, at.layer)->raster;
}

} // namespace

class TestClipboard : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aCopyHoldsTheSelectedTexels();
    void pastingBackChangesNothing();
    void whatIsPastedSoftlyIsLaidOverWhatIsThere();
    void pastingGoesToTheMiddleOfTheSelection();
    void pastingAtTheBorderIsCutOff();
    void clearingTakesAwayTheSelectedTexelsOnly();
    void fillingCoversTheSelectedTexelsOnly();
    void pastingBetweenMapsConverts_data();
    void pastingBetweenMapsConverts();
    void aPastedRowIsARowOfItsOwn();
    void mapsOfAnotherSizeGetTheSameArea();
    void lockedLayersAreNotPastedInto();
    void otherProgramsSeeWhatWasCopied();
    void anImageWithASoftEdgeIsLaidOverAColour_data();
    void anImageWithASoftEdgeIsLaidOverAColour();
    void anImageIsFittedIntoItsArea();
};

void TestClipboard::aCopyHoldsTheSelectedTexels()
{
    Document document(projectWith(MapKind::Gel, {40000, 65535, 0, 0}));
    Selection selection;
    selection.setRectangle(kThere);
    const Clip clip = copyClip(document, firstLayer(document, MapKind::Gel), selection);
    QCOMPARE(clip.width, 32);
    QCOMPARE(clip.height, 16);
    QCOMPARE(clip.uvRect, kThere);
    QVERIFY(std::ranges::all_of(clip.texels, [](const sim::Texel& t) { return t == sim::Texel{40000, 65535, 0, 0}; }));
    selection.setRectangle(std::nullopt);
    QCOMPARE(copyClip(document, firstLayer(document, MapKind::Gel), selection).width, 256);
}

void TestClipboard::pastingBackChangesNothing()
{
    Document document(projectWith(MapKind::Gel, {40000, 65535, 0, 0}));
    Selection selection;
    for (const std::optional<QRectF>& rectangle : {std::optional<QRectF>(), std::optional(kThere)}) {
        selection.setRectangle(rectangle);
        const Clip clip = copyClip(document, firstLayer(document, MapKind::Gel), selection);
        QCOMPARE(pasteCommand(document, firstLayer(document, MapKind::Gel), clip, selection), nullptr);
    }
}

void TestClipboard::whatIsPastedSoftlyIsLaidOverWhatIsThere()
{
    Document soft(projectWith(MapKind::Gel, {40000, 32768, 0, 0}));
    Document document(projectWith(MapKind::Gel, {20000, 65535, 0, 0}));
    const Clip clip = copyClip(soft, firstLayer(soft, MapKind::Gel), {});
    document.push(pasteCommand(document, firstLayer(document, MapKind::Gel), clip, {}));
    const sim::Texel pasted = rasterOf(document, MapKind::Gel).texel(70, 70);
    QVERIFY2(std::abs(pasted[0] - 30000) < 5, qPrintable(QString::number(pasted[0])));
    QCOMPARE(int{pasted[1]}, 65535);
}

void TestClipboard::pastingGoesToTheMiddleOfTheSelection()
{
    Document document(projectWith(MapKind::Gel, {40000, 65535, 0, 0}));
    const LayerAddress gel = firstLayer(document, MapKind::Gel);
    Selection selection;
    selection.setRectangle(kThere);
    const Clip clip = copyClip(document, gel, selection);
    selection.setRectangle(QRectF(0.5, 0.25, 0.25, 0.25)); // Middle: texel (160, 160).
    document.push(pasteCommand(document, gel, clip, selection));
    QCOMPARE(document.undoStack().undoText(), QStringLiteral("Paste into Gel"));
    for (int y = 130; y < 190; ++y)
        for (int x = 130; x < 190; ++x)
            QCOMPARE(rasterOf(document, MapKind::Gel).texel(x, y)[0],
                     x >= 144 && x < 176 && y >= 152 && y < 168 ? 40000 : 0);
}

void TestClipboard::pastingAtTheBorderIsCutOff()
{
    Document document(projectWith(MapKind::Gel, {40000, 65535, 0, 0}));
    const LayerAddress gel = firstLayer(document, MapKind::Gel);
    Selection selection;
    selection.setRectangle(kThere);
    const Clip clip = copyClip(document, gel, selection);
    selection.setRectangle(QRectF(0.0, 0.0, 0.05, 0.05)); // 13 texels; the clip is 32 wide and 16 high.
    document.push(pasteCommand(document, gel, clip, selection));
    QCOMPARE(static_cast<int>(rasterOf(document, MapKind::Gel).texel(0, 255)[0]), 40000);
    QCOMPARE(static_cast<int>(rasterOf(document, MapKind::Gel).texel(255, 0)[0]), 0);
}

void TestClipboard::clearingTakesAwayTheSelectedTexelsOnly()
{
    const Project project = filledPatch(MapKind::Gel, 50000);
    Document document(project);
    Selection selection;
    selection.setRectangle(QRectF(0.25, 0.25, 0.3, 0.3));
    document.push(clearCommand(document, firstLayer(document, MapKind::Gel), selection, QStringLiteral("Cut Gel")));
    QCOMPARE(document.undoStack().undoText(), QStringLiteral("Cut Gel"));
    for (int y = 0; y < 256; y += 3)
        for (int x = 0; x < 256; x += 3)
            QCOMPARE(rasterOf(document, MapKind::Gel).texel(x, y)[1],
                     x >= 64 && x < 141 && y >= 115 && y < 192 ? 0 : 65535);
    document.undo();
    QVERIFY(sameProjects(document.project(), project));
    selection.setRectangle(std::nullopt);
    document.push(clearCommand(document, firstLayer(document, MapKind::Gel), selection, QString()));
    QCOMPARE(rasterOf(document, MapKind::Gel).byteCount(), 0U);
}

void TestClipboard::fillingCoversTheSelectedTexelsOnly()
{
    Document document(projectWith(MapKind::Length, {40000, 30000, 0, 0}));
    const LayerAddress length = firstLayer(document, MapKind::Length);
    const sim::Texel value{20000, 65535, 0, 0};
    Selection selection;
    selection.setRectangle(kThere);
    document.push(fillCommand(document, length, selection, value, QStringLiteral("Fill Length")));
    QCOMPARE(document.undoStack().undoText(), QStringLiteral("Fill Length"));
    for (int y = 0; y < 256; y += 3)
        for (int x = 0; x < 256; x += 3)
            QCOMPARE(rasterOf(document, MapKind::Length).texel(x, y) == value, x >= 64 && x < 96 && y >= 64 && y < 80);
    QCOMPARE(fillCommand(document, length, selection, value, QString()), nullptr); // It is so already.
    selection.setRectangle(std::nullopt);
    document.push(fillCommand(document, length, selection, value, QString()));
    QCOMPARE(rasterOf(document, MapKind::Length).byteCount(), 0U); // Tiles of one value keep only that value.
}

void TestClipboard::pastingBetweenMapsConverts_data()
{
    QTest::addColumn<int>("from");
    QTest::addColumn<QList<int>>("value");
    QTest::addColumn<int>("to");
    QTest::addColumn<QList<int>>("expected");
    const auto row = [](const char* name, MapKind from, const QList<int>& value, MapKind to,
                        const QList<int>& expected) {
        QTest::newRow(name) << static_cast<int>(from) << value << static_cast<int>(to) << expected;
    };
    row("scalars keep the value", MapKind::Length, {12345, 0, 0}, MapKind::Curl, {12345, 0, 0});
    row("a colour's green is density", MapKind::Colour, {13107, 52428, 13107}, MapKind::Density, {39321, 0, 0});
    row("a grey colour is no density", MapKind::Colour, {40000, 40000, 40000}, MapKind::Density, {0, 0, 0});
    row("full length is blue", MapKind::Length, {65535, 0, 0}, MapKind::Colour, {0, 0, 65535});
    row("no length is white", MapKind::Length, {0, 0, 0}, MapKind::Colour, {65535, 65535, 65535});
    row("magenta is a plait", MapKind::Colour, {65535, 0, 65535}, MapKind::Braid, {1, 0, 0});
    row("a plait is magenta", MapKind::Braid, {1, 0, 0}, MapKind::Colour, {65535, 0, 65535});
    row("braids keep the kind", MapKind::Braid, {3, 0, 0}, MapKind::Braid, {3, 0, 0});
}

void TestClipboard::pastingBetweenMapsConverts()
{
    QFETCH(int, from);
    QFETCH(QList<int>, value);
    QFETCH(int, to);
    QFETCH(QList<int>, expected);
    const auto source = static_cast<MapKind>(from);
    const auto target = static_cast<MapKind>(to);
    sim::Texel texel{};
    for (std::size_t i = 0; i < static_cast<std::size_t>(mapSpec(source).valueChannels); ++i)
        texel[i] = static_cast<std::uint16_t>(value[static_cast<qsizetype>(i)]);
    texel[static_cast<std::size_t>(mapSpec(source).valueChannels)] = 50000;
    Document document(projectWith(source, texel));
    Selection selection;
    selection.setRectangle(kThere);
    const Clip clip = copyClip(document, firstLayer(document, source), selection);
    selection.setRectangle(QRectF(0.5, 0.5, 0.25, 0.25));
    document.push(pasteCommand(document, firstLayer(document, target), clip, selection));
    const sim::Texel pasted = rasterOf(document, target).texel(160, 96);
    for (std::size_t i = 0; i < static_cast<std::size_t>(mapSpec(target).valueChannels); ++i)
        QCOMPARE(static_cast<int>(pasted[i]), expected[static_cast<qsizetype>(i)]);
    // What has no values between its own has no soft edge.
    const int coverage = target == MapKind::Braid ? 65535 : 50000;
    QCOMPARE(static_cast<int>(pasted[static_cast<std::size_t>(mapSpec(target).valueChannels)]), coverage);
}

/// Rows 7 and 9 beside each other, pasted so that they touch themselves, pasted where they are, and moved.
void TestClipboard::aPastedRowIsARowOfItsOwn()
{
    constexpr std::uint16_t kFull = 65535;
    Project project = projectWith(MapKind::Braid, {7, kFull, 0, 0});
    sim::TiledRaster& painted = project.groups.front().map(MapKind::Braid).layers.front().raster;
    for (int x = 64; x < 96; ++x)
        for (int y = 72; y < 80; ++y)
            painted.setTexel(x, y, {9, kFull, 0, 0});
    painted.setTexel(70, 74, {1, kFull, 0, 0}); // A plait is none.
    Document document(std::move(project));
    const LayerAddress braids = firstLayer(document, MapKind::Braid);
    Selection selection;
    selection.setRectangle(kThere);
    const Clip clip = copyClip(document, braids, selection);
    QCOMPARE(pasteCommand(document, braids, clip, selection), nullptr);
    const auto at = [&](int x, int y) { return int{rasterOf(document, MapKind::Braid).texel(x, y)[0]}; };
    // To the right, side by side with what it was copied from.
    selection.setRectangle(kThere.translated(kThere.width(), 0.0));
    document.push(pasteCommand(document, braids, clip, selection));
    QCOMPARE(at(90, 66), 7);
    QCOMPARE(at(90, 76), 9);
    QCOMPARE(at(100, 66), 10);
    QCOMPARE(at(100, 76), 11);
    QCOMPARE(at(70 + 32, 74), 1);
    document.undo();
    QCOMPARE(at(100, 66), 0);
    // Cut and pasted, rows keep their numbers.
    selection.setRectangle(kThere);
    document.push(clearCommand(document, braids, selection, QString()));
    selection.setRectangle(kThere.translated(0.3, -0.1));
    document.push(pasteCommand(document, braids, clip, selection));
    const auto moved = [&](int x, int y) { return at(x + 77, y + 26); };
    QCOMPARE(moved(80, 66), 7);
    QCOMPARE(moved(80, 77), 9);
}

void TestClipboard::mapsOfAnotherSizeGetTheSameArea()
{
    Project project = projectWith(MapKind::Gel, {40000, 65535, 0, 0});
    MapStack& curl = project.groups.front().map(MapKind::Curl);
    curl.size = 512;
    curl.layers.front() = makeLayer(project, mapSpec(MapKind::Curl), 512, QStringLiteral("L"));
    Document document(project);
    Selection selection;
    selection.setRectangle(kThere);
    const Clip clip = copyClip(document, firstLayer(document, MapKind::Gel), selection);
    document.push(pasteCommand(document, firstLayer(document, MapKind::Curl), clip, selection));
    for (int y = 100; y < 180; ++y)
        for (int x = 100; x < 220; ++x)
            QCOMPARE(rasterOf(document, MapKind::Curl).texel(x, y)[0],
                     x >= 128 && x < 192 && y >= 128 && y < 160 ? 40000 : 0);
}

void TestClipboard::lockedLayersAreNotPastedInto()
{
    Project project = projectWith(MapKind::Gel, {40000, 65535, 0, 0});
    project.groups.front().map(MapKind::Gel).layers.front().locked = true;
    Document document(project);
    Selection selection;
    selection.setRectangle(kThere);
    const LayerAddress gel = firstLayer(document, MapKind::Gel);
    const Clip clip = copyClip(document, gel, selection);
    QCOMPARE(clip.width, 32);
    QCOMPARE(clearCommand(document, gel, selection, QString()), nullptr);
    selection.setRectangle(QRectF(0.5, 0.5, 0.25, 0.25));
    QCOMPARE(pasteCommand(document, gel, clip, selection), nullptr);
}

void TestClipboard::otherProgramsSeeWhatWasCopied()
{
    Document document(projectWith(MapKind::Length, {65535, 65535, 0, 0}));
    Selection selection;
    selection.setRectangle(kThere);
    const QImage image = imageFromClip(copyClip(document, firstLayer(document, MapKind::Length), selection));
    QCOMPARE(image.size(), QSize(32, 16));
    QCOMPARE(image.pixel(5, 5), qRgba(0, 0, 255, 255));
    selection.setRectangle(QRectF(0.8, 0.8, 0.1, 0.1)); // Nothing is painted there.
    QCOMPARE(qAlpha(imageFromClip(copyClip(document, firstLayer(document, MapKind::Length), selection)).pixel(5, 5)),
             0);
    QVERIFY(imageFromClip({}).isNull());
}

void TestClipboard::anImageWithASoftEdgeIsLaidOverAColour_data()
{
    QTest::addColumn<int>("alpha");
    QTest::addColumn<QColor>("expected"); // Of #804000 over #8a4b2a.
    QTest::newRow("nothing of it") << 0 << QColor(138, 75, 42);
    QTest::newRow("a fifth") << 51 << QColor(136, 73, 34);
    QTest::newRow("half") << 128 << QColor(133, 69, 21);
    QTest::newRow("all") << 255 << QColor(128, 64, 0);
}

void TestClipboard::anImageWithASoftEdgeIsLaidOverAColour()
{
    QFETCH(int, alpha);
    QFETCH(QColor, expected);
    QImage image(256, 256, QImage::Format_ARGB32);
    image.fill(QColor(128, 64, 0, alpha));
    Document document(patchProject());
    const LayerAddress colour = firstLayer(document, MapKind::Colour);
    const sim::Texel below{138 * 257, 75 * 257, 42 * 257, 65535};
    document.push(fillCommand(document, colour, {}, below, QStringLiteral("Fill")));
    const Clip clip = clipFromImage(image, MapKind::Colour, false, 256, QRectF(0.0, 0.0, 1.0, 1.0));
    document.push(pasteCommand(document, colour, clip, {}));
    const sim::Texel texel = rasterOf(document, MapKind::Colour).texel(128, 128);
    QCOMPARE(int{texel[3]}, 65535);
    const QColor found(texel[0] / 257, texel[1] / 257, texel[2] / 257);
    QVERIFY2(std::abs(found.red() - expected.red()) <= 1 && std::abs(found.green() - expected.green()) <= 1 &&
                 std::abs(found.blue() - expected.blue()) <= 1,
             qPrintable(found.name()));
}

void TestClipboard::anImageIsFittedIntoItsArea()
{
    QImage image(40, 20, QImage::Format_RGB32);
    image.fill(Qt::blue);
    const Clip clip = clipFromImage(image, MapKind::Length, false, 256, QRectF(0.0, 0.0, 1.0, 1.0));
    QCOMPARE(QSize(clip.width, clip.height), QSize(256, 128));
    QCOMPARE(clip.uvRect, QRectF(0.0, 0.25, 1.0, 0.5));
    const auto isFull = [](const sim::Texel& t) { return t[0] > 65500 && t[1] > 65500; }; // Scaling rounds.
    QVERIFY(std::ranges::all_of(clip.texels, isFull));
    Document document(projectWith(MapKind::Length, {0, 65535, 0, 0}));
    document.push(pasteCommand(document, firstLayer(document, MapKind::Length), clip, {}));
    QVERIFY(isFull(rasterOf(document, MapKind::Length).texel(128, 128)));
    QCOMPARE(rasterOf(document, MapKind::Length).texel(128, 20)[1], std::uint16_t{0});
}

HAIRPAINT_TEST(TestClipboard, None)
#include "test_clipboard.moc"
