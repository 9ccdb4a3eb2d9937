// Painting in the real window is seen: texels, hairs and the 3D picture follow every tool in both areas, while the
// pointer is down, after undo and redo, and after the project went through its file.
#include "model/document/group_commands.h"
#include "model/files/layer_files.h"
#include "model/files/preset_file.h"
#include "tests/app/window_fixture.h"
#include "tests/support/test_program.h"
#include "view/panels/map_row.h"

namespace hairpaint::app {

class TestWindowPainting : public QObject, private WindowFixture
{
    Q_OBJECT
private:
    static constexpr double kSeen = 0.003; ///< Fraction of the picture that hair must have changed.
    /// Least difference of a pixel's channels together that counts, where hair changes its colour in place.
    static constexpr int kLittle = 12;
    static constexpr double kSame = 0.0005; ///< Fraction that two pictures of the same may differ by.

    [[nodiscard]] QWidget& paper() { return m_window->paintView(); }

    /// A bald head in still air, Density ready to be painted, seen from the front. `whole`: so that a short stroke
    /// grows hair to be counted.
    void openBald(bool whole = false)
    {
        model::Project project = model::newProject();
        project.wind.enabled = false;
        openWholeWindow(whole ? std::move(project) : test::thinned(std::move(project)));
        m_window->headView().setCamera(frontCamera());
        key(Qt::Key_1);
        key(Qt::Key_B);
        model::ToolSettings settings = editor().tools().settings();
        settings.brushSizeM *= 2.0F;
        editor().tools().setSettings(settings);
    }

    [[nodiscard]] rendering::Camera frontCamera()
    {
        rendering::Camera camera = m_window->headView().camera();
        camera.azimuthRad = 0.0F;
        return camera;
    }

    void undo() { key(Qt::Key_Z, Qt::ControlModifier); }
    void redo() { key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier); }

    /// Undone and redone, the newest step's texels, hairs and picture go and come back.
    void showUndoAndRedo(const QImage& before, std::size_t hairsBefore, glm::vec2 painted)
    {
        awaitNewestHair();
        const std::size_t grown = hairs();
        const sim::Texel texel = texelAt(painted.x, painted.y);
        const int steps = stack().index();
        undo();
        QCOMPARE(stack().index(), steps - 1);
        QVERIFY(texelAt(painted.x, painted.y) != texel);
        awaitNewestHair();
        QCOMPARE(hairs(), hairsBefore);
        QVERIFY(difference(before, picture()) < kSame);
        redo();
        QCOMPARE(stack().index(), steps);
        QCOMPARE(texelAt(painted.x, painted.y), texel);
        awaitNewestHair();
        QCOMPARE(hairs(), grown);
        QVERIFY(difference(before, picture()) > kSeen);
    }

private Q_SLOTS:
    void initTestCase() { prepareApplication(); }
    void cleanup() { m_window.reset(); }

    void aStrokeGrowsHairWhileThePointerIsDown_data()
    {
        QTest::addColumn<bool>("onTheHead");
        QTest::newRow("on the paper") << false;
        QTest::newRow("on the head") << true;
    }
    void aStrokeGrowsHairWhileThePointerIsDown()
    {
        QFETCH(bool, onTheHead);
        openBald(true);
        const QByteArray before = savedBytes("stroke-before.hairpaint");
        const QImage bald = picture();
        QCOMPARE(hairs(), std::size_t{0});
        const glm::vec2 from = onTheHead ? m_window->headView().skinAt({300.0, 200.0}).value_or(sim::SurfacePoint{}).uv
                                         : glm::vec2(0.45F, 0.5F);
        const auto [area, start] =
            onTheHead ? onHead(from.x, from.y) : std::pair<QWidget*, QPoint>{&paper(), paintPoint(from.x, from.y)};
        const QPoint along(onTheHead ? 40 : 60, 0);

        QTest::mouseMove(area, start);
        QTest::mousePress(area, Qt::LeftButton, {}, start);
        for (int i = 1; i <= 6; ++i)
            QTest::mouseMove(area, start + along * i / 12);
        QTRY_VERIFY_WITH_TIMEOUT(hairs() > 50, kPatienceMs);
        QTRY_VERIFY_WITH_TIMEOUT(difference(bald, picture()) > kSeen, kPatienceMs);
        QVERIFY(editor().tools().stroking());
        QCOMPARE(stack().count(), 0);
        QVERIFY(savedBytes("stroke-running.hairpaint") == before);
        const std::size_t half = hairs();
        for (int i = 7; i <= 12; ++i)
            QTest::mouseMove(area, start + along * i / 12);
        QTRY_VERIFY_WITH_TIMEOUT(hairs() > half, kPatienceMs);
        QVERIFY(editor().tools().stroking());

        QTest::mouseRelease(area, Qt::LeftButton, {}, start + along);
        QVERIFY(!editor().tools().stroking());
        QCOMPARE(stack().count(), 1);
        QVERIFY(texelAt(from.x, from.y)[1] > 0);
        showUndoAndRedo(bald, 0, from);
        undo();
        QVERIFY(savedBytes("stroke-undone.hairpaint") == before);
    }

    void aGradientGrowsHair()
    {
        openBald();
        const QImage bald = picture();
        key(Qt::Key_G);
        drag(paper(), paintPoint(0.5F, 0.58F), paintPoint(0.5F, 0.42F));
        QCOMPARE(stack().count(), 1);
        QTRY_VERIFY_WITH_TIMEOUT(hairs() > 500, kPatienceMs);
        QTRY_VERIFY_WITH_TIMEOUT(difference(bald, picture()) > kSeen, kPatienceMs);
        showUndoAndRedo(bald, 0, {0.5F, 0.6F});
    }

    void whatIsCopiedGrowsHairWhereItIsPasted()
    {
        openBald(true);
        drag(paper(), paintPoint(0.40F, 0.5F), paintPoint(0.44F, 0.5F));
        QTRY_VERIFY_WITH_TIMEOUT(hairs() > 100, kPatienceMs);
        key(Qt::Key_F8);
        QVERIFY(session().paused());
        awaitNewestHair();
        const std::size_t once = hairs();
        const QImage left = picture();
        key(Qt::Key_M);
        drag(paper(), paintPoint(0.37F, 0.56F), paintPoint(0.47F, 0.44F));
        key(Qt::Key_C, Qt::ControlModifier);
        drag(paper(), paintPoint(0.53F, 0.56F), paintPoint(0.63F, 0.44F));
        QCOMPARE(int(texelAt(0.58F, 0.5F)[1]), 0);
        QCOMPARE(stack().count(), 1);
        key(Qt::Key_V, Qt::ControlModifier);
        QCOMPARE(stack().count(), 2);
        QCOMPARE(texelAt(0.58F, 0.5F), texelAt(0.42F, 0.5F));
        QTRY_VERIFY_WITH_TIMEOUT(hairs() > once + once / 2, kPatienceMs);
        QTRY_VERIFY_WITH_TIMEOUT(difference(left, picture()) > kSeen, kPatienceMs);
        showUndoAndRedo(left, once, {0.58F, 0.5F});
    }

    void pastingIntoAnotherMapChangesThatMapAndThePicture()
    {
        openBald(true);
        rendering::Camera camera = frontCamera();
        camera.distanceM *= 1.5F; // The hair, which stands up while it is paused, is seen whole.
        m_window->headView().setCamera(camera);
        drag(paper(), paintPoint(0.40F, 0.5F), paintPoint(0.60F, 0.5F));
        QTRY_VERIFY_WITH_TIMEOUT(hairs() > 500, kPatienceMs);
        key(Qt::Key_F8);
        awaitNewestHair();
        const std::size_t count = hairs();
        const QImage usual = picture();
        key(Qt::Key_M);
        drag(paper(), paintPoint(0.37F, 0.58F), paintPoint(0.63F, 0.42F));
        key(Qt::Key_C, Qt::ControlModifier);
        key(Qt::Key_2);
        QCOMPARE(int(texelAt(0.5F, 0.5F)[1]), 0);
        key(Qt::Key_V, Qt::ControlModifier);
        QVERIFY(stack().undoText().contains(QStringLiteral("Length")));
        QVERIFY(texelAt(0.5F, 0.5F)[1] > 0);
        QTRY_VERIFY_WITH_TIMEOUT(difference(usual, picture()) > kSeen, kPatienceMs);
        showUndoAndRedo(usual, count, {0.5F, 0.5F});
    }

    /// Frizz, width and gloss: the hair that is there looks otherwise while the pointer is down, and none comes or
    /// goes.
    void whatHairLooksLikeIsPaintedByItsRow_data()
    {
        QTest::addColumn<int>("map");
        QTest::newRow("frizz") << static_cast<int>(model::MapKind::Frizz);
        QTest::newRow("width") << static_cast<int>(model::MapKind::Width);
        QTest::newRow("gloss") << static_cast<int>(model::MapKind::Gloss);
    }
    void whatHairLooksLikeIsPaintedByItsRow()
    {
        QFETCH(int, map);
        model::Project project = model::newProject();
        project.wind.enabled = false;
        sim::GroupSettings& group = project.groups.front().settings;
        group.material.shine = 1.0F;
        group.material.widthM = 150e-6F;
        group.greatestFrizzM = 0.02F;
        group.variation.grey =
            map == static_cast<int>(model::MapKind::Gloss) ? 0.0F : 1.0F; // Seen before what is dark.
        openWholeWindow(std::move(project));
        key(Qt::Key_1);
        key(Qt::Key_B);
        model::ToolSettings settings = editor().tools().settings();
        settings.brushSizeM *= 3.0F;
        editor().tools().setSettings(settings);
        drag(paper(), paintPoint(0.40F, 0.5F), paintPoint(0.60F, 0.5F));
        QTRY_VERIFY_WITH_TIMEOUT(hairs() > 500, kPatienceMs);
        key(Qt::Key_F8); // It stands as it grows.
        awaitNewestHair();
        awaitFinePicture();
        const std::size_t count = hairs();
        const QImage usual = picture();
        const auto rows = m_window->findChildren<view::MapRow*>();
        QTest::mouseClick(rows[map], Qt::LeftButton);
        QCOMPARE(static_cast<int>(editor().target().map()), map);
        const QByteArray before = savedBytes("look-before.hairpaint");

        const QPoint start = paintPoint(0.40F, 0.5F);
        const QPoint end = paintPoint(0.60F, 0.5F);
        QTest::mouseMove(&paper(), start);
        QTest::mousePress(&paper(), Qt::LeftButton, {}, start);
        for (int i = 1; i <= 12; ++i)
            QTest::mouseMove(&paper(), start + (end - start) * i / 12);
        const auto changed = [&] { return difference(usual, picture(), kLittle); };
        QTRY_VERIFY_WITH_TIMEOUT(changed() > kSeen, kPatienceMs);
        QVERIFY(editor().tools().stroking());
        QVERIFY(savedBytes("look-running.hairpaint") == before);
        QTest::mouseRelease(&paper(), Qt::LeftButton, {}, end);
        QCOMPARE(stack().count(), 2);
        awaitNewestHair();
        QCOMPARE(hairs(), count);
        awaitFinePicture();
        const double painted = changed();
        QVERIFY(painted > kSeen);
        undo();
        awaitNewestHair();
        awaitFinePicture();
        QVERIFY2(changed() < 0.1 * painted, qPrintable(QStringLiteral("%1 of %2").arg(changed()).arg(painted)));
        redo();
        awaitNewestHair();
        awaitFinePicture();
        QCOMPARE(hairs(), count);
        QVERIFY(changed() > 0.9 * painted);
        undo();
        QVERIFY(savedBytes("look-undone.hairpaint") == before);
    }

    void aStepMadeWhileSavingIsNotTakenForSaved()
    {
        openBald();
        const QString path = m_folder.filePath(QStringLiteral("meanwhile.hairpaint"));
        m_window->files().setPath(path);
        drag(paper(), paintPoint(0.42F, 0.5F), paintPoint(0.58F, 0.5F));
        awaitNewestHair();
        QTRY_COMPARE_WITH_TIMEOUT(session().hair(), Session::Hair::Current, kPatienceMs);
        // As a number that was being typed becomes a step when the progress window takes the focus.
        QTimer::singleShot(0, m_window.get(), [this] {
            model::Document& document = session().document();
            document.push(model::renameGroupCommand(document, document.committed().groups.front().id,
                                                    QStringLiteral("Meanwhile")));
        });
        QVERIFY(m_window->files().save());
        QCOMPARE(session().document().committed().groups.front().name, QStringLiteral("Meanwhile"));
        const model::Result<model::Project> read = model::loadProject(path);
        QVERIFY(read);
        QCOMPARE(session().document().modified(), read->groups.front().name != QLatin1String("Meanwhile"));
        QVERIFY(m_window->files().save());
        QVERIFY(!session().document().modified());
    }

    void aFilesPictureIsDrawnInTheBackground()
    {
        openBald();
        std::atomic<QThread*> drawnOn = nullptr;
        m_window->files().setThumbnailMaker([&drawnOn] {
            return [&drawnOn](const model::Progress&) {
                drawnOn = QThread::currentThread();
                return QImage();
            };
        });
        m_window->files().setPath(m_folder.filePath(QStringLiteral("background.hairpaint")));
        QVERIFY(m_window->files().save());
        QVERIFY(drawnOn != nullptr && drawnOn != thread());
    }

    /// Though the simulation has not seen it yet.
    void theFilesPictureShowsWhatIsSaved()
    {
        openBald();
        const auto saved = [this](const char* name) {
            m_window->files().setPath(m_folder.filePath(QString::fromLatin1(name)));
            const bool written = m_window->files().save();
            const auto archive = model::ArchiveReader::open(m_window->files().path());
            return written && archive ? model::readThumbnail(*archive) : QImage();
        };
        const QImage bald = saved("picture-bald.hairpaint");
        const model::Result<model::Preset> style = model::loadPreset(model::listPresets({}).front().path);
        QVERIFY(style && !bald.isNull());
        session().document().push(model::applyPresetCommand(session().document(), *style));
        awaitNewestHair(); // The picture is of what the 3D area shows.
        QVERIFY(difference(bald, saved("picture-styled.hairpaint")) > 0.05);
    }

    void savingByItsKeyAndOpeningAgainGivesTheSame()
    {
        openBald();
        const QString path = m_folder.filePath(QStringLiteral("painted.hairpaint"));
        m_window->files().setPath(path);
        const QImage bald = picture();
        key(Qt::Key_F8);
        // The second time, only what changed is encoded again.
        for (const float v : {0.5F, 0.55F}) {
            awaitNewestHair();
            const std::size_t before = hairs();
            drag(paper(), paintPoint(0.42F, v), paintPoint(0.58F, v));
            QTRY_VERIFY_WITH_TIMEOUT(hairs() > before, kPatienceMs);
            QVERIFY(session().document().modified());
            key(Qt::Key_S, Qt::ControlModifier);
            QTRY_VERIFY_WITH_TIMEOUT(!session().document().modified(), kPatienceMs);
            QVERIFY(QFile::exists(path));
            const model::Result<model::Project> read = model::loadProject(path);
            QVERIFY(read);
            const model::LayerAddress at = editor().target().address();
            QVERIFY(read->layer(at.group, at.map, at.layer)->raster ==
                    session().document().committed().layer(at.group, at.map, at.layer)->raster);
        }
        awaitNewestHair();
        const QImage painted = picture();
        QVERIFY(difference(bald, painted) > kSeen);
        const std::size_t count = hairs();
        const model::Project saved = session().document().committed();
        const QByteArray bytes = savedBytes("saved.hairpaint");

        m_window->files().newProject();
        QTRY_VERIFY_WITH_TIMEOUT(hairs() != count, kPatienceMs);
        m_window->openFile(path);
        QCOMPARE(m_window->files().path(), path);
        QVERIFY(!session().document().modified());
        QVERIFY(savedBytes("reopened.hairpaint") == bytes);
        const model::HairGroup& group = saved.groups.front();
        for (const model::MapStack& stack : group.maps)
            for (const model::Layer& layer : stack.layers) {
                const model::Layer* again = session().document().committed().layer(group.id, stack.kind, layer.id);
                QVERIFY(again != nullptr && again->raster == layer.raster);
            }
        awaitNewestHair();
        QCOMPARE(hairs(), count);
        QVERIFY(difference(painted, picture()) < kSame);
    }

    void aStyleSavesAndReopensTheSame()
    {
        openWindow(model::newProject());
        const QString path = m_folder.filePath(QStringLiteral("style.hairpaint"));
        m_window->openFile(model::listPresets({}).at(1).path);
        QCOMPARE(stack().count(), 1);
        QTRY_VERIFY_WITH_TIMEOUT(hairs() > 10'000, kPatienceMs);
        const std::size_t count = hairs();
        m_window->files().setPath(path);
        key(Qt::Key_S, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(!session().document().modified(), kPatienceMs);
        const QByteArray bytes = savedBytes("style-kept.hairpaint");

        m_window->files().newProject();
        QVERIFY(m_window->files().openPath(path));
        QTRY_COMPARE_WITH_TIMEOUT(hairs(), count, kPatienceMs);
        QVERIFY(savedBytes("style-again.hairpaint") == bytes);
        QVERIFY(!session().document().modified());
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestWindowPainting, Widgets)
#include "test_window_painting.moc"
