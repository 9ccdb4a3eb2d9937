// What comes in from other programs and goes out to them, by the window's menus and dialogs and dropped on it.
#include "app/styles/library.h"
#include "model/files/glb_writing.h"
#include "model/files/head_file.h"
#include "model/files/preset_file.h"
#include "model/files/project_file.h"
#include "model/styles/preset.h"
#include "tests/app/exchange_fixture.h"
#include "tests/app/program.h"
#include "tests/app/thin_project.h"
#include "tests/support/character.h"
#include "tests/support/file_faults.h"
#include "tests/support/foreign_heads.h"
#include "tests/support/locations.h"
#include "tests/support/test_program.h"
#include "view/dialogs/head_side.h"
#include "view/panels/status_readout.h"
#include "view/panels/style_strip.h"
#include "view/panels/style_tile.h"

#include <QComboBox>
#include <QLabel>
#include <QTimer>

namespace hairpaint::app {

class TestExchange : public QObject, private ExchangeFixture
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { prepareDialogs(); }
    void cleanup()
    {
        closeWindow();
        qunsetenv("HAIRPAINT_IMPORT_MS");
    }

    void anAcceptedHeadReplacesTheOld_data() { menuOrDrop(); }
    void anAcceptedHeadReplacesTheOld()
    {
        QFETCH(bool, dropped);
        open(model::newProject());
        model::Document& document = session().document();
        const std::shared_ptr<const model::Head> old = document.committed().head;
        bring(ballHead("ball.glb"), "file.importHead", dropped);
        QTRY_COMPARE_WITH_TIMEOUT(stack().count(), 1, kPatienceMs);
        const model::Project& project = document.committed();
        QVERIFY(project.head != old && !project.head->builtIn);
        QCOMPARE(project.head->name, QStringLiteral("ball"));
        QVERIFY(project.head->skin->atUv({0.5F, 0.5F}).has_value());
        QVERIFY(!project.worn.empty() && model::shapesOfHead(project.worn) != model::builtInEllipsoids());
        document.undo();
        QVERIFY(document.committed().head == old);
        QVERIFY(model::shapesOfHead(document.committed().worn) == model::builtInEllipsoids());
        document.redo();
        trigger("file.head.bust-2");
        QVERIFY(document.committed().head->builtIn);
        QCOMPARE(stack().count(), 2);
    }

    void aReplacedHeadHasTheHairAtTheSamePlaces()
    {
        open(test::thinned(starterProject()));
        model::Document& document = session().document();
        const model::Project before = document.committed();
        trigger("file.head.bust-1");
        QCOMPARE(stack().count(), 1);
        const model::Project& after = document.committed();
        QCOMPARE(after.head->name, QStringLiteral("bust-1"));
        QVERIFY(model::shapesOfHead(after.worn) == model::builtInEllipsoids(QStringLiteral("bust-1")));
        const auto growsAt = [this, &after](sim::HeadLandmark landmark, glm::vec3 beside) {
            const sim::SurfacePoint point = after.head->skin->nearest((*after.head->landmarks)[landmark] + beside);
            const auto density = session().document().resolvedNow(after.groups.front().id, model::MapKind::Density);
            return density->sampleScalar(point.uv) > 0.3F;
        };
        const glm::vec3 upward(0.015F, 0.015F, 0.0F);
        QVERIFY(growsAt(sim::HeadLandmark::Hairline, upward));
        QVERIFY(!growsAt(sim::HeadLandmark::Hairline, -upward));
        QVERIFY(growsAt(sim::HeadLandmark::Nape, upward) && !growsAt(sim::HeadLandmark::Nape, -upward));
        document.undo();
        QVERIFY(document.committed().head == before.head && document.committed().groups == before.groups);
        // A project on the older head opens on it.
        document.redo();
        QVERIFY(!savedBytes("older.hairpaint").isEmpty());
        const model::Result<model::Project> read = model::loadProject(path("older.hairpaint"));
        QVERIFY(read && read->head == after.head);
    }

    void aMovedLandmarkTakesTheHairAlong()
    {
        open(test::thinned(starterProject()));
        model::Document& document = session().document();
        QVERIFY(!action("file.landmarks")->isEnabled()); // Those of a built-in head are known.
        m_answers->file = headFile("child.glb", test::childOf(document.committed().head->skin->mesh()).mesh);
        trigger("file.importHead");
        QCOMPARE(stack().count(), 1);
        const model::Project before = document.committed();
        QVERIFY(before.head->landmarks && action("file.landmarks")->isEnabled());

        trigger("file.landmarks"); // Looked at, and nothing moved.
        QCOMPARE(stack().count(), 1);
        m_answers->movesLandmarks = [](view::LandmarksDialog& dialog) {
            auto& head = *dialog.findChild<view::HeadSide*>(QStringLiteral("movedLandmarks"));
            const std::optional<QPointF> at = head.positionOf(sim::HeadLandmark::Hairline);
            QVERIFY(at && !head.positionOf(sim::HeadLandmark::Nape)); // From the front.
            const QPoint from = at->toPoint();
            QTest::mousePress(&head, Qt::LeftButton, {}, from);
            QTest::mouseMove(&head, from + QPoint(0, 10));
            QTest::mouseMove(&head, from + QPoint(0, 20));
            QTest::mouseRelease(&head, Qt::LeftButton, {}, from + QPoint(0, 20));
        };
        trigger("file.landmarks");
        QCOMPARE(stack().count(), 2);
        const model::Project& after = document.committed();
        const glm::vec3 old = (*before.head->landmarks)[sim::HeadLandmark::Hairline];
        const glm::vec3 moved = (*after.head->landmarks)[sim::HeadLandmark::Hairline];
        QVERIFY2(old.y - moved.y > 0.008F && old.y - moved.y < 0.03F, qPrintable(QString::number(old.y - moved.y)));
        QVERIFY((*after.head->landmarks)[sim::HeadLandmark::Chin] ==
                (*before.head->landmarks)[sim::HeadLandmark::Chin]);
        QVERIFY(after.head->skin == before.head->skin);
        const auto densityAt = [&](glm::vec3 positionHd) {
            const auto density = document.resolvedNow(after.groups.front().id, model::MapKind::Density);
            return density->sampleScalar(after.head->skin->nearest(positionHd).uv);
        };
        const glm::vec3 between = 0.5F * (old + moved) + glm::vec3(0.015F, 0.0F, 0.0F); // Beside the parting.
        QVERIFY(densityAt(between) > 0.3F);
        document.undo();
        QVERIFY(densityAt(between) < 0.1F);
        QVERIFY(document.committed().head == before.head);
    }

    void browsOnAHeadWithoutLandmarksAreAskedFor()
    {
        model::Project project = model::newProject();
        auto bare = std::make_shared<model::Head>(*project.head);
        bare->builtIn = false;
        bare->landmarks.reset();
        project.head = bare;
        open(std::move(project));
        trigger("hair.face");
        QCOMPARE(m_answers->said.size(), 1);
        QVERIFY(m_answers->said.constFirst().contains(QStringLiteral("Landmarks")));
        QCOMPARE(stack().count(), 0);
    }

    void landmarksThatAreNotWantedChangeNothing()
    {
        open(test::smallProject());
        m_answers->takesLandmarks = false;
        m_answers->file = ballHead("ball.glb");
        trigger("file.importHead");
        QCOMPARE(stack().count(), 0);
        QVERIFY(session().document().committed().head->builtIn);
    }

    void aHeadThatIsNotWantedChangesNothing()
    {
        open(test::smallProject());
        const QByteArray before = savedBytes("head-before.hairpaint");
        m_answers->takesHead = false;
        m_answers->file = ballHead("ball.glb");
        trigger("file.importHead");
        QCOMPARE(stack().count(), 0);
        QVERIFY(savedBytes("head-after.hairpaint") == before);
        QVERIFY(m_answers->said.isEmpty());
    }

    void helpersThatFailCostOneSentenceEach()
    {
        open(test::smallProject());
        const QByteArray before = savedBytes("helper-before.hairpaint");
        for (const QByteArray mode : {"abort", "silent", "hang", "endless garbage", "missing", "image of wrong size",
                                      "mesh with a wrong index", "mesh with NaN", "good"}) {
            qputenv("HAIRPAINT_IMPORT",
                    mode == "missing" ? m_folder.path().toLocal8Bit() + "/none" : test::fakeHelper().toLocal8Bit());
            qputenv("HAIRPAINT_FAKE_HELPER", mode);
            if (mode == "hang")
                qputenv("HAIRPAINT_IMPORT_MS", "500"); // It is given up soon.
            m_answers->said.clear();
            drop(ballHead("crashing.glb"));
            QTRY_VERIFY2_WITH_TIMEOUT(m_answers->said.size() == 1, mode.constData(), kPatienceMs);
            const QString said = m_answers->said.constFirst();
            QVERIFY2(said.contains(QStringLiteral("crashing.glb")) && !said.contains(QLatin1Char('\n')),
                     qPrintable(said));
            QTRY_VERIFY2_WITH_TIMEOUT(QApplication::activeModalWidget() == nullptr, mode.constData(), kPatienceMs);
            QVERIFY2(m_answers->said.size() == 1, mode.constData());
            QVERIFY2(stack().count() == 0 && !session().document().modified(), mode.constData());
            QVERIFY2(savedBytes("helper-after.hairpaint") == before, mode.constData());
            qunsetenv("HAIRPAINT_IMPORT_MS");
        }
        // The program goes on.
        qputenv("HAIRPAINT_IMPORT", test::importProgram().toLocal8Bit());
        drop(ballHead("good.glb"));
        QTRY_COMPARE_WITH_TIMEOUT(stack().count(), 1, kPatienceMs);
    }

    /// A mesh without uvs, in centimetres, put on and taken off again.
    void aMeshIsPutOn()
    {
        open(test::smallProject());
        const std::vector<model::Worn> before = session().document().committed().worn;
        QFile file(path("box.obj"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("v -0.02 0 -0.01\nv 0.02 0 -0.01\nv 0.02 0 0.01\nv -0.02 0 0.01\nv 0 0.05 0\n"
                   "f 1 2 3 4\nf 1 5 2\nf 2 5 3\nf 3 5 4\nf 4 5 1\n");
        file.close();
        m_answers->file = file.fileName();
        trigger("hair.addMesh");
        QCOMPARE(m_answers->said, QStringList());
        QCOMPARE(stack().count(), 1);
        const model::Worn* worn = session().document().committed().wornThing(editor().options().chosenWorn());
        QVERIFY(worn != nullptr && worn->kind == model::WornKind::Mesh && worn->ownMesh.isRead());
        QCOMPARE(worn->ownMesh.own->name, QStringLiteral("box"));
        QVERIFY(glm::distance(worn->shape.semiAxesM, glm::vec3(0.02F, 0.025F, 0.01F)) < 1e-5F);
        QVERIFY(worn->anchor && worn->group == editor().target().group());
        QVERIFY(action("hair.mirrorWorn")->isEnabled());
        trigger("hair.mirrorWorn");
        QCOMPARE(countOf(session().document().committed().worn, model::WornKind::Mesh), std::size_t{2});
        session().document().undo();
        session().document().undo();
        QVERIFY(session().document().committed().worn == before);
        QVERIFY(!action("hair.mirrorWorn")->isEnabled());
        // What cannot be worn is told, and changes nothing.
        QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
        file.write("no mesh");
        file.close();
        trigger("hair.addMesh");
        QCOMPARE(m_answers->said.size(), 1);
        QVERIFY(m_answers->said.front().contains(QStringLiteral("box.obj")));
        m_answers->file.clear();
        trigger("hair.addMesh");
        QCOMPARE(m_answers->said.size(), 1);
        QVERIFY(session().document().committed().worn == before);
    }

    /// A glTF of six parts in five materials, two of them with a texture, read by the helper.
    void aMeshIsPutOnWithItsMaterials()
    {
        open(test::smallProject());
        const model::RiggedMesh character = test::makeCharacter();
        QFile file(path("figure.glb"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(model::glbFromMesh(character));
        file.close();
        m_answers->file = file.fileName();
        trigger("hair.addMesh");
        QCOMPARE(m_answers->said, QStringList());
        const model::Worn* worn = session().document().committed().wornThing(editor().options().chosenWorn());
        QVERIFY(worn != nullptr && worn->ownMesh.isRead());
        const std::vector<model::HeadPart> surfaces = wornSurfaces(*worn, nullptr);
        QCOMPARE(surfaces.size(), std::size_t{5});
        std::vector<const sim::MeshTexture*> shown;
        for (const model::HeadPart& surface : surfaces)
            if (surface.texture)
                shown.push_back(surface.texture.get());
        QCOMPARE(shown.size(), std::size_t{2});
        QVERIFY(*shown[0] == character.textures[0] && *shown[1] == character.textures[1]);
        QCOMPARE(m_window->headView().pictureScene().solids.size(), std::size_t{5});
    }

    void cancelEndsASilentHelper_data()
    {
        QTest::addColumn<QByteArray>("action");
        QTest::addColumn<QByteArray>("mode");
        for (const char* action : {"file.importHead", "file.loadImage", "file.saveImage"})
            for (const char* mode : {"hang", "long body never sent, then hang"})
                QTest::addRow("%s, %s", action, mode) << QByteArray(action) << QByteArray(mode);
    }
    void cancelEndsASilentHelper()
    {
        QFETCH(QByteArray, action);
        QFETCH(QByteArray, mode);
        open(test::smallProject());
        const QByteArray before = savedBytes("silent-before.hairpaint");
        qputenv("HAIRPAINT_IMPORT", test::fakeHelper().toLocal8Bit());
        qputenv("HAIRPAINT_FAKE_HELPER", mode);
        m_answers->cancels = true;
        m_answers->file = action == "file.saveImage"    ? path("never.png")
                          : action == "file.importHead" ? ballHead("silent.glb")
                                                        : halfImage("silent.png", Qt::blue);
        trigger(action.constData()); // Comes back once it is cancelled.
        QVERIFY2(m_answers->said.isEmpty(), qPrintable(m_answers->said.join(QLatin1Char('|'))));
        QVERIFY(m_done.isEmpty());
        QVERIFY(!QFile::exists(path("never.png")));
        QVERIFY(savedBytes("silent-after.hairpaint") == before);
    }

    void aDroppedStyleOrProjectIsTaken()
    {
        open(model::newProject());
        drop(model::listPresets({}).at(1).path);
        QTRY_COMPARE_WITH_TIMEOUT(stack().count(), 1, kPatienceMs);
        QVERIFY(!layers().empty());
        const QByteArray bytes = savedBytes("dropped.hairpaint");
        session().document().markSaved();
        m_window->files().newProject();
        QVERIFY(savedBytes("other.hairpaint") != bytes);
        drop(path("dropped.hairpaint"));
        QTRY_COMPARE_WITH_TIMEOUT(m_window->files().path(), path("dropped.hairpaint"), kPatienceMs);
        QVERIFY(savedBytes("dropped-again.hairpaint") == bytes);
    }

    void thisHairIsSavedAsAStyle()
    {
        const QString file = ownPresetFolder() + QStringLiteral("/sunday--best.hairpreset");
        QFile::remove(file);
        open(starterProject());
        m_answers->name = QStringLiteral("Sunday, Best");
        auto* strip = m_window->findChild<view::StyleStrip*>();
        const auto tile = [strip](const QString& path) -> view::StyleTile* {
            for (view::StyleTile* one : strip->findChildren<view::StyleTile*>())
                if (one->path() == path)
                    return one;
            return nullptr;
        };
        for (const bool again : {false, true}) {
            QTest::mouseClick(tile({}), Qt::LeftButton);
            QCOMPARE(m_answers->said.size(), again ? 1 : 0); // Whether it may be replaced.
            const model::Result<model::Preset> style = model::loadPreset(file);
            QVERIFY(style);
            QCOMPARE(style->name, QStringLiteral("Sunday, Best"));
            QVERIFY(style->picture.isNull()); // No view of this moment.
            QTRY_VERIFY_WITH_TIMEOUT(tile(file) != nullptr && tile(file)->own(), kPatienceMs);
            // Drawn in the background as those of all other styles are, whatever the camera looks at.
            QTRY_VERIFY_WITH_TIMEOUT(tile(file)->hasPicture(), kPatienceMs);
            QCOMPARE(m_done.size(), again ? 2 : 1);
        }
        QCOMPARE(stack().count(), 0);
        // Applied to another project it gives this hair.
        const sim::TiledRaster wanted = layers().back().raster;
        session().document().replace(model::newProject());
        QTest::mouseClick(tile(file), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(stack().count(), 1, kPatienceMs);
        QVERIFY(layers().back().raster == wanted);

        // It gets another name, and its file with it.
        m_answers->name = QStringLiteral("Monday");
        Q_EMIT strip->ordered(file, view::StyleOrder::Rename);
        const QString renamed = ownPresetFolder() + QStringLiteral("/monday.hairpreset");
        QTRY_VERIFY_WITH_TIMEOUT(tile(file) == nullptr && tile(renamed) != nullptr, kPatienceMs);
        QVERIFY(!QFile::exists(file));
        QCOMPARE(tile(renamed)->text(), QStringLiteral("Monday"));
        QFile::remove(renamed);
    }

#ifdef Q_OS_LINUX
    void aStyleThatCantBeSavedIsToldAndTheOldOneStays_data()
    {
        QTest::addColumn<bool>("isFull");
        QTest::newRow("read-only") << false;
        QTest::newRow("full") << true;
    }
    void aStyleThatCantBeSavedIsToldAndTheOldOneStays()
    {
        QFETCH(bool, isFull);
        const QString file = ownPresetFolder() + QStringLiteral("/kept.hairpreset");
        QVERIFY(QDir().mkpath(ownPresetFolder()));
        QVERIFY(model::savePreset(model::presetFrom(model::newProject(), QStringLiteral("Kept")), file));
        const QByteArray before = test::contentOf(file);
        open(test::thinned(starterProject()));
        m_answers->name = QStringLiteral("Kept");
        auto* strip = m_window->findChild<view::StyleStrip*>();
        const auto save = [strip] {
            for (view::StyleTile* one : strip->findChildren<view::StyleTile*>())
                if (one->path().isEmpty())
                    return QTest::mouseClick(one, Qt::LeftButton);
        };
        {
            const QByteArray positionHd = QFile::encodeName(ownPresetFolder());
            const test::FileRefusal refusal(positionHd.constData(),
                                            isFull ? test::FileRefusal::Why::Full : test::FileRefusal::Why::ReadOnly);
            save();
            QCOMPARE(m_answers->said.size(), 2); // Whether it may be replaced, and that it was not.
            QVERIFY2(m_answers->said.back().contains(QStringLiteral("kept.hairpreset")),
                     qPrintable(m_answers->said.back()));
            QVERIFY(m_done.isEmpty());
        }
        QVERIFY(test::contentOf(file) == before);
        QCOMPARE(QDir(ownPresetFolder()).entryList({QStringLiteral(".*")}, QDir::Files | QDir::Hidden), QStringList());
        // Somebody removes the library: it is made again.
        QVERIFY(QDir(ownPresetFolder()).removeRecursively());
        save();
        QCOMPARE(m_done.size(), 1);
        QVERIFY(model::loadPreset(file));
        QFile::remove(file);
    }
#endif

    void thePictureIsSaved()
    {
        open(model::newProject());
        m_answers->file = path("portrait.png");
        trigger("file.picture");
        QCOMPARE(m_done, QStringList(QStringLiteral("portrait.png written")));
        const QImage saved(path("portrait.png"));
        QCOMPARE(saved.size(), QSize(2048, 2048));
        const QImage small = saved.scaled(320, 320, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
        QVERIFY(difference(small.convertToFormat(QImage::Format_RGB32), picture()) < 0.05);
        QImage flat(320, 320, QImage::Format_RGB32);
        flat.fill(small.pixel(0, 0));
        QVERIFY(difference(small, flat) > 0.1);
    }

    void aPictureThatIsDrawnCanBeCancelled()
    {
        open(starterProject());
        // The wait for the newest hair can be cancelled too; here it is the picture that is meant.
        QTRY_VERIFY_WITH_TIMEOUT(session().hair() == Session::Hair::Current, kPatienceMs);
        m_answers->file = path("unwanted.png");
        m_answers->cancels = true;
        trigger("file.picture");
        if (m_answers->cancelled == 0)
            return; // A GPU has drawn it before there was anything to click.
        QVERIFY(m_done.isEmpty() && m_answers->said.isEmpty());
        QVERIFY(!QFile::exists(path("unwanted.png")));
        // The status line says so.
        const auto labels = m_window->findChild<view::StatusReadout*>()->findChildren<QLabel*>();
        QVERIFY(std::ranges::any_of(labels, [](const QLabel* label) {
            return label->text() == QStringLiteral("The picture 'unwanted.png' was not saved: cancelled");
        }));
    }

    void cancelledDialogsDoNothing()
    {
        open(test::smallProject());
        const QByteArray before = savedBytes("cancel-before.hairpaint");
        for (const char* action : {"file.loadImage", "file.loadGrey", "file.saveImage", "file.importHead",
                                   "file.exportHair", "file.picture", "file.open", "file.saveAs"}) {
            trigger(action);
            QVERIFY2(stack().count() == 0, action);
            QVERIFY2(m_done.isEmpty() && m_answers->said.isEmpty(), action);
            QVERIFY2(savedBytes("cancel-after.hairpaint") == before, action);
        }
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestExchange, Widgets)
#include "test_exchange.moc"
