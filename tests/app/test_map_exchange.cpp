// Maps for other programs, by the window's menus: images, the sheet, the clipboard, and layers edited elsewhere.
#include "app/exchange/map_exchange.h"
#include "app/settings/languages.h"
#include "model/document/layer_commands.h"
#include "model/exporting/map_images.h"
#include "model/files/glb_writing.h"
#include "model/files/head_file.h"
#include "model/heads/part_choice.h"
#include "model/values/names.h"
#include "tests/app/exchange_fixture.h"
#include "tests/app/program.h"
#include "tests/app/thin_project.h"
#include "tests/support/character.h"
#include "tests/support/test_program.h"
#include "view/panels/status_readout.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDesktopServices>
#include <QGuiApplication>
#include <QLabel>
#include <QMimeData>
#include <QUrl>

#include <algorithm>

namespace hairpaint::app {

using test::contentOf;

/// Stands for the program that opens images.
class Painter : public QObject
{
    Q_OBJECT
public:
    QString opened;

public Q_SLOTS:
    void open(const QUrl& url) { opened = url.toLocalFile(); }
};

class TestMapExchange : public QObject, private ExchangeFixture
{
    Q_OBJECT
private:
    Painter m_painter;
    QStringList m_told;

    void openTold(model::Project project)
    {
        open(std::move(project));
        m_told.clear();
        QObject::connect(m_window->findChild<FileWork*>(), &FileWork::done, m_answers.get(),
                         [this](const QString& text) { m_told += text; });
    }
    /// Where Blender keeps what is the user's; nothing is there yet.
    [[nodiscard]] QDir freshBlender() const
    {
#ifdef Q_OS_WIN
        qputenv("APPDATA", path("roaming").toLocal8Bit());
        QDir folder(path("roaming") + QStringLiteral("/Blender Foundation/Blender"));
#else
        QDir folder(QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation) +
                    QStringLiteral("/blender"));
#endif
        folder.removeRecursively();
        return folder;
    }
    /// Another program saves: all is blue.
    static bool paintOver(const QString& file)
    {
        QImage image = QImage(file).convertToFormat(QImage::Format_ARGB32);
        image.fill(Qt::blue);
        return image.save(file);
    }
    [[nodiscard]] QString freshFolder(const char* name) const
    {
        const QString folder = path(name);
        QDir(folder).removeRecursively();
        QDir().mkpath(folder);
        return folder;
    }

private Q_SLOTS:
    void initTestCase()
    {
        prepareDialogs();
        QDesktopServices::setUrlHandler(QStringLiteral("file"), &m_painter, "open");
    }
    void cleanup()
    {
        closeWindow();
        m_painter.opened.clear();
    }
    void cleanupTestCase()
    {
        QDesktopServices::unsetUrlHandler(QStringLiteral("file"));
    }

    void mapsAreSavedAsTheDialogSays_data()
    {
        QTest::addColumn<int>("range");
        QTest::addColumn<int>("count");
        const auto kinds = static_cast<int>(model::mapSpecs().size());
        QTest::newRow("this map") << static_cast<int>(view::MapRange::Active) << 1;
        QTest::newRow("the group's") << static_cast<int>(view::MapRange::Group) << kinds;
        QTest::newRow("all") << static_cast<int>(view::MapRange::All) << 2 * kinds;
    }
    void mapsAreSavedAsTheDialogSays()
    {
        QFETCH(int, range);
        QFETCH(int, count);
        model::Project project = test::smallProject(); // Whose maps are quickly written.
        sim::TiledRaster& lengths = project.groups.front().map(model::MapKind::Length).layers.front().raster;
        lengths = sim::TiledRaster(lengths.size(), lengths.channels(), {40'000, 65'535});
        project.groups.push_back(model::makeGroup(project, QStringLiteral("Beard"), lengths.size()));
        openTold(std::move(project));
        editor().target().setMap(model::MapKind::Length);
        m_answers->file = freshFolder("maps");
        m_answers->choosesMaps = [range](view::ExportMapsDialog& dialog) {
            const QList<QComboBox*> boxes = dialog.findChildren<QComboBox*>();
            boxes[0]->setCurrentIndex(range);
            QTest::keyClick(boxes[1], Qt::Key_Down); // As grey,
            QTest::keyClick(boxes[3], Qt::Key_Down); // of 8 bits.
        };
        trigger("file.saveImages");
        QVERIFY2(m_answers->said.isEmpty(), qPrintable(m_answers->said.join(QLatin1Char('|'))));
        QCOMPARE(m_told.size(), qsizetype{1});
        const QDir folder(path("maps"));
        QCOMPARE(folder.entryList(QDir::Files | QDir::Hidden).size(), qsizetype{count});
        const QImage length(folder.filePath(QStringLiteral("Scalp-length.png")));
        QVERIFY(length.isGrayscale() && length.depth() == 8);
        const auto resolved = session().document().resolvedNow(editor().target().group(), model::MapKind::Length);
        QCOMPARE(length.width(), resolved->size());
        QVERIFY(resolved->texel(0, 0)[0] > 0);
        const int middle = length.width() / 2;
        QVERIFY(std::abs(qGray(length.pixel(middle, middle)) - resolved->texel(middle, middle)[0] / 257) <= 1);
    }

    void anImageForEachUvTileGoesOutAndComesBackAsOneLayer()
    {
        model::RiggedMesh mesh;
        for (const int tile : {0, 1}) {
            test::addBall(mesh, {0.0F, 0.3F * static_cast<float>(tile), 0.0F}, 0.12F, 16);
            test::closePart(mesh, "Ball_" + std::to_string(tile), "").tile = {tile, 0};
        }
        mesh.skeleton = {};
        const auto head =
            model::makeHead(QStringLiteral("tiles"), model::glbFromMesh(model::arranged(mesh)), 1.0F, model::UpAxis::Y);
        QVERIFY(head);
        model::Project project = test::smallProject();
        project.head = *head;
        sim::TiledRaster& lengths = project.groups.front().map(model::MapKind::Length).layers.front().raster;
        lengths = sim::TiledRaster(lengths.size(), lengths.channels(), {40'000, 65'535});
        // A texel of the left tile; the next is of the right one, and both lie in the lower half.
        lengths.setTexel(10, 200, {20'000, 65'535});
        lengths.setTexel(200, 200, {10'000, 65'535});
        openTold(std::move(project));
        editor().target().setMap(model::MapKind::Length);
        m_answers->file = freshFolder("tiles");
        m_answers->choosesMaps = [](view::ExportMapsDialog& dialog) {
            const QList<QComboBox*> boxes = dialog.findChildren<QComboBox*>();
            boxes[0]->setCurrentIndex(static_cast<int>(view::MapRange::Active));
            boxes[2]->setCurrentIndex(1); // An image each.
        };
        trigger("file.saveImages");
        QVERIFY2(m_answers->said.isEmpty(), qPrintable(m_answers->said.join(QLatin1Char('|'))));
        const QDir folder(path("tiles"));
        QCOMPARE(folder.entryList(QDir::Files),
                 (QStringList{QStringLiteral("Scalp-length.1001.png"), QStringLiteral("Scalp-length.1002.png")}));
        QVERIFY2(m_told.first().startsWith(QLatin1Char('1')), qPrintable(m_told.first())); // One map.

        m_answers->file = folder.filePath(QStringLiteral("Scalp-length.1002.png"));
        trigger("file.loadImage");
        QVERIFY2(m_answers->said.isEmpty(), qPrintable(m_answers->said.join(QLatin1Char('|'))));
        QCOMPARE(stack().count(), 1);
        const model::Layer& layer = layers().back();
        QCOMPARE(layer.name, QStringLiteral("Scalp-length"));
        const auto near = [&layer](int x, int y, int value) {
            return layer.raster.texel(x, y)[1] == 65'535 && std::abs(int{layer.raster.texel(x, y)[0]} - value) <= 1;
        };
        QVERIFY(near(10, 200, 20'000) && near(200, 200, 10'000) && near(11, 200, 40'000));
        QCOMPARE(layer.raster.texel(10, 100)[1], std::uint16_t{0}); // No tile lies there.
        trigger("edit.undo");
        QCOMPARE(layers().size(), std::size_t{1});
    }

    void mapsThatAreThereAreReplacedOnlyAfterAsking()
    {
        openTold(test::smallProject());
        m_answers->file = freshFolder("again");
        trigger("file.saveImages");
        QVERIFY(m_answers->said.isEmpty());
        trigger("file.saveImages");
        QCOMPARE(m_answers->said.size(), qsizetype{1});
        QCOMPARE(m_told.size(), qsizetype{2});
    }

    void mapsThatCantBeSavedAreToldOfOnce()
    {
        openTold(test::smallProject());
        const QString folder = freshFolder("taken");
        QVERIFY(QDir(folder).mkdir(QStringLiteral("Scalp-length.png"))); // Where a file should go.
        m_answers->file = folder;
        trigger("file.saveImages");
        QCOMPARE(m_answers->said.size(), qsizetype{2}); // The question, and the sentence.
        QVERIFY2(m_answers->said.back().contains(QStringLiteral("Scalp-length.png")),
                 qPrintable(m_answers->said.back()));
        QCOMPARE(QDir(folder).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot).size(), qsizetype{1});
    }

    void theSheetIsSaved()
    {
        openTold(test::smallProject());
        m_answers->file = path("layout"); // The ending is the filter's.
        trigger("file.uvSheet");
        QCOMPARE(m_told, QStringList(QStringLiteral("layout.pdf written")));
        QVERIFY(contentOf(path("layout.pdf")).startsWith("%PDF"));
    }

    void whatAnotherProgramSavesComesBackAsOneStep()
    {
        openTold(test::smallProject());
        editor().target().setMap(model::MapKind::Length);
        const model::LayerAddress target = editor().target().address();
        trigger("file.editOutside");
        QVERIFY2(m_answers->said.isEmpty(), qPrintable(m_answers->said.join(QLatin1Char('|'))));
        QVERIFY(m_painter.opened.endsWith(QStringLiteral(".png")));
        QImage image(m_painter.opened);
        QVERIFY(image.hasAlphaChannel());
        QCOMPARE(stack().count(), 0);

        image = image.convertToFormat(QImage::Format_ARGB32);
        for (int y = 0; y < image.height() / 2; ++y)
            for (int x = 0; x < image.width(); ++x)
                image.setPixelColor(x, y, Qt::blue);
        // As careful programs save: another file under the old one's name.
        const QString aside = m_painter.opened + QStringLiteral(".new");
        QVERIFY(image.save(aside, "PNG") && QFile::remove(m_painter.opened) && QFile::rename(aside, m_painter.opened));
        QTRY_COMPARE_WITH_TIMEOUT(stack().count(), 1, kPatienceMs);
        QCOMPARE(stack().undoText(), QStringLiteral("Edit Length elsewhere"));
        const auto texel = [&](int y) {
            const model::Layer* layer = session().document().committed().layer(target.group, target.map, target.layer);
            return layer->raster.texel(10, y);
        };
        QCOMPARE(texel(10), (sim::Texel{65535, 65535, 0, 0}));
        const int low = image.height() - 10;
        QCOMPARE(texel(low)[1], std::uint16_t{0});

        // Saved again, into the same file.
        for (int x = 0; x < image.width(); ++x)
            image.setPixelColor(x, low, Qt::blue);
        QVERIFY(image.save(m_painter.opened));
        QTRY_COMPARE_WITH_TIMEOUT(stack().count(), 2, kPatienceMs);
        QCOMPARE(texel(low), (sim::Texel{65535, 65535, 0, 0}));
        session().document().undo();
        session().document().undo();
        QCOMPARE(texel(10)[1], std::uint16_t{0});
    }

    void whatBelongsToAnotherProjectStaysOut()
    {
        openTold(test::smallProject());
        editor().target().setMap(model::MapKind::Length);
        trigger("file.editOutside");
        session().document().replace(model::newProject());
        const sim::TiledRaster before = layers().front().raster;
        QVERIFY(paintOver(m_painter.opened));
        QTRY_COMPARE_WITH_TIMEOUT(m_answers->said.size(), qsizetype{1}, kPatienceMs);
        QVERIFY2(m_answers->said.front().contains(QFileInfo(m_painter.opened).fileName()),
                 qPrintable(m_answers->said.front()));
        QCOMPARE(stack().count(), 0);
        QVERIFY(layers().front().raster == before);
    }

    void aLayerThatWasLockedMeanwhileStays()
    {
        openTold(test::smallProject());
        editor().target().setMap(model::MapKind::Length);
        trigger("file.editOutside");
        const model::LayerAddress target = editor().target().address();
        model::Document& document = session().document();
        model::LayerProperties locked =
            model::propertiesOf(*document.committed().layer(target.group, target.map, target.layer));
        locked.locked = true;
        document.push(model::setLayerPropertiesCommand(document, target, locked, QStringLiteral("Lock")));
        const int steps = stack().count();
        QVERIFY(paintOver(m_painter.opened));
        QTRY_COMPARE_WITH_TIMEOUT(m_answers->said.size(), qsizetype{1}, kPatienceMs);
        QVERIFY2(m_answers->said.front().contains(QStringLiteral("locked")), qPrintable(m_answers->said.front()));
        QCOMPARE(stack().count(), steps);
    }

#ifdef Q_OS_LINUX
    void withoutAFolderForItTheImageIsToldOf()
    {
        openTold(test::smallProject());
        const QByteArray before = qgetenv("TMPDIR");
        qputenv("TMPDIR", "/proc");
        trigger("file.editOutside");
        before.isNull() ? qunsetenv("TMPDIR") : qputenv("TMPDIR", before);
        QCOMPARE(m_answers->said.size(), qsizetype{1});
        QVERIFY2(m_answers->said.front().contains(QStringLiteral("'/proc'")), qPrintable(m_answers->said.front()));
        QVERIFY(m_painter.opened.isEmpty());
        trigger("file.editOutside");
        QVERIFY(!m_painter.opened.isEmpty());
    }
#endif

    void theAddonGoesIntoEveryBlenderThatIsThere()
    {
        const QDir blender = freshBlender();
        for (const char* version : {"2.93", "3.4", "4.2", "notes"})
            QVERIFY(blender.mkpath(QLatin1StringView(version)));
        openTold(test::smallProject());
        trigger("file.blender");
        QCOMPARE(m_answers->said.size(), qsizetype{1});
        QVERIFY2(m_answers->said.front().contains(QStringLiteral("3.4, 4.2")), qPrintable(m_answers->said.front()));
        const auto script = [&blender](const char* version) {
            return contentOf(
                blender.filePath(QLatin1StringView(version) + QStringLiteral("/scripts/addons/hair_paint_import.py")));
        };
        QVERIFY(script("3.4").contains("bl_info") && script("4.2") == script("3.4"));
        QVERIFY(script("2.93").isEmpty());
        (void)freshBlender();
    }

    void withoutBlenderTheAddonIsSaved()
    {
        (void)freshBlender();
        openTold(test::smallProject());
        m_answers->file = path("addon");
        trigger("file.blender");
        QVERIFY(m_answers->said.isEmpty());
        QVERIFY(contentOf(path("addon.py")).contains("bl_info"));
    }

    void anImageFromElsewhereIsPasted()
    {
        openTold(test::smallProject());
        editor().target().setMap(model::MapKind::Length);
        QImage image(64, 64, QImage::Format_RGB32);
        image.fill(Qt::blue);
        QGuiApplication::clipboard()->setImage(image);
        trigger("edit.paste");
        QCOMPARE(stack().count(), 1);
        const int middle = layers().front().raster.size() / 2;
        const auto isBlue = [&] {
            const sim::Texel texel = layers().back().raster.texel(middle, middle);
            return texel[0] > 65500 && texel[1] > 65500; // Scaling rounds.
        };
        QVERIFY(isBlue());
        // What is copied here goes out as an image, and comes back exactly.
        trigger("edit.copy");
        QCOMPARE(QGuiApplication::clipboard()->image().pixelColor(middle, middle), QColor(Qt::blue));
        trigger("edit.clear");
        QCOMPARE(layers().back().raster.texel(middle, middle)[1], std::uint16_t{0});
        trigger("edit.paste");
        QVERIFY(isBlue());
    }

    void aPictureFromABrowserIsLaidAsIfPasted()
    {
        openTold(test::smallProject());
        editor().target().setMap(model::MapKind::Length);
        QImage image(64, 64, QImage::Format_RGB32);
        image.fill(Qt::blue);
        QMimeData dragged; // As browsers have it: the picture, and where it came from.
        dragged.setUrls({QUrl(QStringLiteral("https://example.org/hair.png"))});
        dragged.setImageData(image);
        drop(dragged);
        QTRY_COMPARE_WITH_TIMEOUT(stack().count(), 1, kPatienceMs);
        const int middle = layers().front().raster.size() / 2;
        QVERIFY(layers().back().raster.texel(middle, middle)[0] > 65500);
    }

    void anAddressAloneIsToldOf()
    {
        openTold(test::smallProject());
        QMimeData dragged;
        dragged.setUrls({QUrl(QStringLiteral("https://example.org/hair.png"))});
        drop(dragged);
        const auto labels = m_window->findChild<view::StatusReadout*>()->findChildren<QLabel*>();
        const auto isTold = [&labels] {
            return std::ranges::any_of(labels, [](const QLabel* label) {
                return label->text().startsWith(QLatin1String("Only an address was dropped"));
            });
        };
        QTRY_VERIFY_WITH_TIMEOUT(isTold(), kPatienceMs);
        QCOMPARE(stack().count(), 0);
    }

    /// The last: nothing switches back to the language of the sources.
    void dialogsCallGroupsAsTheWindowDoes()
    {
        QCOMPARE(speak(QStringLiteral("es")), QStringLiteral("es"));
        model::Project project = test::thinned(starterProject());
        model::HairGroup beard = project.groups.front();
        beard.id += 100;
        beard.name = QStringLiteral("Beard");
        project.groups.push_back(beard);
        const QString scalp = model::shownName(project.groups.front().name);
        QVERIFY(scalp != project.groups.front().name);
        openTold(std::move(project));
        QStringList shown;
        m_answers->choosesMaps = [&shown](view::ExportMapsDialog& dialog) {
            shown += dialog.findChildren<QComboBox*>()[0]->itemText(1);
        };
        m_answers->choosesExport = [&shown](view::ExportHairDialog& dialog) {
            shown += dialog.findChildren<QCheckBox*>()[0]->text();
        };
        trigger("file.saveImages"); // Cancelled, for want of a file's name.
        trigger("file.exportHair");
        QCOMPARE(shown.size(), qsizetype{2});
        for (const QString& text : shown)
            QVERIFY2(text.contains(scalp), qPrintable(text));
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestMapExchange, Widgets)
#include "test_map_exchange.moc"
