// What comes in from other programs and goes out to them, by the window's menus and dialogs and dropped on it.
#include "app/exchange.h"
#include "model/commands/commands.h"
#include "model/files/glb.h"
#include "model/files/head_file.h"
#include "model/files/preset_file.h"
#include "model/preset.h"
#include "tests/app/window_fixture.h"
#include "tests/support/test_heads.h"
#include "tests/support/test_program.h"
#include "view/dialogs/head_import_dialog.h"
#include "view/panels/style_strip.h"
#include "view/panels/style_tile.h"

#include <QDialogButtonBox>
#include <QDropEvent>
#include <QFileDialog>
#include <QInputDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>

namespace hairpaint::app {

namespace {

/// Answers dialogs that wait while it lives, as a user would.
class Answerer : public QObject
{
public:
    QString file;          ///< Typed into file dialogs; they are cancelled where it is empty.
    QString name;          ///< Typed where a name is asked for.
    bool takesHead = true; ///< Whether the head's dialog is accepted.
    bool cancels = false;  ///< Whether Cancel is clicked in progress windows.
    QStringList said;      ///< What message boxes said.

    Answerer() { startTimer(20); }

protected:
    void timerEvent(QTimerEvent* /*event*/) override
    {
        QWidget* waiting = QApplication::activeModalWidget();
        if (auto* files = qobject_cast<QFileDialog*>(waiting)) {
            files->findChild<QLineEdit*>()->setText(file);
            press(*files, !file.isEmpty());
        } else if (auto* input = qobject_cast<QInputDialog*>(waiting)) {
            input->setTextValue(name);
            press(*input, true);
        } else if (auto* head = qobject_cast<view::HeadImportDialog*>(waiting)) {
            press(*head, takesHead);
        } else if (auto* box = qobject_cast<QMessageBox*>(waiting)) {
            said += box->text();
            QAbstractButton* yes = box->button(QMessageBox::Yes);
            (yes != nullptr ? yes : box->buttons().constFirst())->click();
        } else if (waiting != nullptr && cancels && waiting->objectName() == QLatin1String("progressWindow")) {
            QTest::mouseClick(waiting->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Cancel),
                              Qt::LeftButton);
        }
    }

private:
    static void press(QDialog& dialog, bool accept)
    {
        for (QAbstractButton* button : dialog.findChild<QDialogButtonBox*>()->buttons()) {
            const QDialogButtonBox::ButtonRole role = dialog.findChild<QDialogButtonBox*>()->buttonRole(button);
            if (role == (accept ? QDialogButtonBox::AcceptRole : QDialogButtonBox::RejectRole))
                return button->click();
        }
    }
};

QByteArray contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class TestExchange : public QObject, private WindowFixture
{
    Q_OBJECT
private:
    std::unique_ptr<Answerer> m_answers;
    QStringList m_done; ///< What the status bar was told.

    void open(model::Project project)
    {
        qputenv("HAIRPAINT_IMPORT", HAIRPAINT_IMPORT_PROGRAM); // Lies beside the program, not beside this test.
        openWindow(std::move(project));
        m_answers = std::make_unique<Answerer>();
        m_done.clear();
        connect(m_window->findChild<Exchange*>(), &Exchange::done, this,
                [this](const QString& text) { m_done += text; });
    }

    void trigger(const char* id) { m_window->actions().find(QLatin1StringView(id))->trigger(); }
    [[nodiscard]] QString path(const char* name) const { return m_folder.filePath(QString::fromLatin1(name)); }

    void drop(const QString& file)
    {
        QMimeData dragged;
        dragged.setUrls({QUrl::fromLocalFile(file)});
        QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &dragged, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(m_window.get(), &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent let(QPointF(300, 300), Qt::CopyAction, &dragged, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(m_window.get(), &let);
        QVERIFY(let.isAccepted());
    }

    /// Chosen in the dialog that the action opens, or dropped on the window.
    void bring(const QString& file, const char* action, bool dropped)
    {
        m_answers->file = file;
        if (dropped)
            drop(file);
        else
            trigger(action);
    }

    [[nodiscard]] const std::vector<model::Layer>& layers()
    {
        return session().document().committed().group(editor().activeGroup())->map(editor().activeMap()).layers;
    }

    /// Left half `left`, right half white.
    [[nodiscard]] QString halfImage(const char* name, QColor left)
    {
        QImage image(64, 64, QImage::Format_RGB32);
        image.fill(Qt::white);
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 32; ++x)
                image.setPixelColor(x, y, left);
        return image.save(path(name)) ? path(name) : QString();
    }

    [[nodiscard]] QString ballHead(const char* name)
    {
        QFile file(path(name));
        if (!file.open(QIODevice::WriteOnly))
            return {};
        file.write(model::glbFromMesh(test::makeBallHead(24, 0.11F)));
        return file.fileName();
    }

    static void menuOrDrop()
    {
        QTest::addColumn<bool>("dropped");
        QTest::newRow("by menu") << false;
        QTest::newRow("dropped") << true;
    }

private Q_SLOTS:
    void initTestCase()
    {
        QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
        prepareApplication();
    }
    void cleanup()
    {
        m_window.reset();
        m_answers.reset();
    }

    void anImageBecomesALayerOfTheMap_data() { menuOrDrop(); }
    void anImageBecomesALayerOfTheMap()
    {
        QFETCH(bool, dropped);
        open(model::newProject());
        const QByteArray before = savedBytes("image-before.hairpaint");
        editor().setActiveMap(model::MapKind::Length);
        const std::size_t count = layers().size();
        bring(halfImage("fringe.png", Qt::blue), "file.loadImage", dropped);
        QTRY_COMPARE_WITH_TIMEOUT(layers().size(), count + 1, kPatienceMs);
        const model::Layer& layer = layers().back();
        QCOMPARE(layer.name, QStringLiteral("fringe"));
        const int size = layer.raster.size();
        QCOMPARE(layer.raster.texel(size / 4, size / 2), (sim::Texel{65535, 65535, 0, 0}));
        QCOMPARE(layer.raster.texel(size * 3 / 4, size / 2), (sim::Texel{0, 65535, 0, 0}));
        QCOMPARE(stack().count(), 1);
        QCOMPARE(stack().undoText(), QStringLiteral("Load fringe.png into Length"));
        session().document().undo();
        QVERIFY(savedBytes("image-after.hairpaint") == before);
        QVERIFY2(m_answers->said.isEmpty(), qPrintable(m_answers->said.join(QLatin1Char('|'))));
    }

    void aGreyImageIsTheValueItself()
    {
        open(model::newProject());
        editor().setActiveMap(model::MapKind::Gel);
        const auto left = [this] {
            const sim::TiledRaster& raster = layers().back().raster;
            return int(raster.texel(raster.size() / 4, raster.size() / 2)[0]);
        };
        m_answers->file = halfImage("grey.png", QColor(51, 51, 51));
        trigger("file.loadGrey");
        QCOMPARE(stack().count(), 1);
        QVERIFY2(std::abs(left() - 65535 / 5) < 300, qPrintable(QString::number(left())));
        trigger("file.loadImage"); // By the scale, grey is nothing.
        QCOMPARE(stack().count(), 2);
        QCOMPARE(left(), 0);
    }

    void anImageOfAnotherSizeIsSaidToBeResampled()
    {
        open(model::newProject());
        const int size = session().document().committed().groups.front().map(model::MapKind::Density).size;
        for (const int side : {size / 2, size}) {
            m_done.clear();
            QImage image(side, side, QImage::Format_RGB32);
            image.fill(Qt::black);
            m_answers->file = path("square.png");
            QVERIFY(image.save(m_answers->file));
            trigger("file.loadGrey");
            QCOMPARE(m_done.isEmpty(), side == size);
        }
        QVERIFY(m_answers->said.isEmpty());
    }

    void withoutAGroupThereIsNoMapToSaveOrLoad()
    {
        model::Project project = model::newProject();
        project.groups.clear();
        open(std::move(project));
        m_answers->file = halfImage("alone.png", Qt::black);
        trigger("file.loadGrey");
        QCOMPARE(m_answers->said.size(), 1);
        m_answers->file = path("no-map.png");
        trigger("file.saveImage");
        QCOMPARE(m_answers->said.size(), 2);
        QVERIFY(!QFile::exists(path("no-map.png")));
        QCOMPARE(stack().count(), 0);
    }

    void whatIsOnlyShownIsNoPartOfASavedMap()
    {
        open(model::newProject());
        model::Document& document = session().document();
        const model::Id group = document.committed().groups.front().id;
        const model::Id layer = document.committed().groups.front().map(model::MapKind::Density).layers.front().id;
        editor().setActiveMap(model::MapKind::Density);
        model::EditSession shown;
        document.show(shown, {.policy = model::EditPolicy::Drop},
                      {.aspect = model::Change::Aspect::LayerList, .group = group, .map = model::MapKind::Density},
                      [=](model::Project& project) {
                          sim::TiledRaster& raster = project.layer(group, model::MapKind::Density, layer)->raster;
                          for (int tile = 0; tile < raster.tileCount(); ++tile)
                              raster.setUniform(tile, {65535, 65535});
                      });
        m_answers->file = path("density.png");
        trigger("file.saveImage");
        const QImage saved(path("density.png"));
        QCOMPARE(saved.pixelColor(saved.width() / 2, saved.height() / 2), QColor(Qt::white));
    }

    void aMapGoesOutAsAnImageAndComesBackTheSame()
    {
        open(model::newProject());
        key(Qt::Key_2);
        key(Qt::Key_G);
        drag(m_window->paintView(), paintPoint(0.5F, 0.65F), paintPoint(0.5F, 0.35F));
        QCOMPARE(stack().count(), 1);
        const auto shown = [this] {
            return session().document().resolved(editor().activeGroup(), editor().activeMap());
        };
        const std::shared_ptr<const sim::TiledRaster> before = shown();
        m_answers->file = path("length"); // The ending is added.
        trigger("file.saveImage");
        QCOMPARE(m_done, QStringList(QStringLiteral("length.png written")));
        QCOMPARE(QImage(path("length.png")).size(), QSize(before->size(), before->size()));
        QCOMPARE(stack().count(), 1);

        drop(path("length.png"));
        QTRY_COMPARE_WITH_TIMEOUT(stack().count(), 2, kPatienceMs);
        QCOMPARE(shown()->size(), before->size());
        for (int y = 0; y < before->size(); y += 7)
            for (int x = 0; x < before->size(); x += 7)
                QVERIFY(std::abs(int(shown()->texel(x, y)[0]) - int(before->texel(x, y)[0])) <= 1);
    }

    void anAcceptedHeadTakesThePlaceOfTheOld_data() { menuOrDrop(); }
    void anAcceptedHeadTakesThePlaceOfTheOld()
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
        QVERIFY(!project.ellipsoids.empty() && project.ellipsoids != model::builtInEllipsoids());
        document.undo();
        QVERIFY(document.committed().head == old);
        QVERIFY(document.committed().ellipsoids == model::builtInEllipsoids());
        document.redo();
        trigger("file.builtInHead");
        QVERIFY(document.committed().head->builtIn);
        QCOMPARE(stack().count(), 2);
    }

    void aHeadThatIsNotWantedChangesNothing()
    {
        open(model::newProject());
        const QByteArray before = savedBytes("head-before.hairpaint");
        m_answers->takesHead = false;
        m_answers->file = ballHead("ball.glb");
        trigger("file.importHead");
        QCOMPARE(stack().count(), 0);
        QVERIFY(savedBytes("head-after.hairpaint") == before);
        QVERIFY(m_answers->said.isEmpty());
    }

    void aHelperThatFailsCostsOneSentence_data()
    {
        QTest::addColumn<QByteArray>("mode");
        for (const char* mode : {"abort", "silent", "hang", "endless garbage", "missing"})
            QTest::newRow(mode) << QByteArray(mode);
    }
    void aHelperThatFailsCostsOneSentence()
    {
        QFETCH(QByteArray, mode);
        open(model::newProject());
        const QByteArray before = savedBytes("helper-before.hairpaint");
        qputenv("HAIRPAINT_IMPORT",
                mode == "missing" ? m_folder.path().toLocal8Bit() + "/none" : HAIRPAINT_FAKE_HELPER_PROGRAM);
        qputenv("HAIRPAINT_FAKE_HELPER", mode);
        drop(ballHead("crashing.glb"));
        QTRY_COMPARE_WITH_TIMEOUT(m_answers->said.size(), 1, kPatienceMs);
        const QString& said = m_answers->said.constFirst();
        QVERIFY2(said.contains(QStringLiteral("crashing.glb")) && !said.contains(QLatin1Char('\n')), qPrintable(said));
        QTRY_VERIFY_WITH_TIMEOUT(QApplication::activeModalWidget() == nullptr, kPatienceMs);
        QCOMPARE(m_answers->said.size(), 1);
        QCOMPARE(stack().count(), 0);
        QVERIFY(!session().document().modified());
        QVERIFY(savedBytes("helper-after.hairpaint") == before);
        // The program goes on.
        qputenv("HAIRPAINT_IMPORT", HAIRPAINT_IMPORT_PROGRAM);
        drop(ballHead("good.glb"));
        QTRY_COMPARE_WITH_TIMEOUT(stack().count(), 1, kPatienceMs);
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
        open(model::newProject());
        const QByteArray before = savedBytes("silent-before.hairpaint");
        qputenv("HAIRPAINT_IMPORT", HAIRPAINT_FAKE_HELPER_PROGRAM);
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
        Q_EMIT strip->renameStyleRequested(file);
        const QString renamed = ownPresetFolder() + QStringLiteral("/monday.hairpreset");
        QTRY_VERIFY_WITH_TIMEOUT(tile(file) == nullptr && tile(renamed) != nullptr, kPatienceMs);
        QVERIFY(!QFile::exists(file));
        QCOMPARE(tile(renamed)->text(), QStringLiteral("Monday"));
        m_answers->said.clear(); // The question before the trash names the style as the strip does.
        Q_EMIT strip->deleteStyleRequested(renamed);
        QVERIFY2(m_answers->said.value(0).contains(QStringLiteral("Monday")), qPrintable(m_answers->said.value(0)));
        QFile::remove(renamed);
    }

    void hairGoesOutAsCurves()
    {
        open(model::newProject());
        key(Qt::Key_1);
        drag(m_window->paintView(), paintPoint(0.45F, 0.5F), paintPoint(0.55F, 0.5F));
        QTRY_VERIFY_WITH_TIMEOUT(hairs() > 100, kPatienceMs);
        awaitNewestHair();
        m_answers->file = path("curls");
        const std::size_t count = hairs();
        trigger("file.exportHair");
        QCOMPARE(m_done, QStringList(QStringLiteral("curls.hair written")));
        const QByteArray bytes = contentOf(path("curls.hair"));
        QVERIFY(bytes.size() > 128 && bytes.startsWith("HAIR"));
        QCOMPARE(std::size_t{qFromLittleEndian<quint32>(bytes.constData() + 4)}, count);
    }

    void theHairThatGoesOutIsThatOfTheDocument()
    {
        open(model::newProject());
        const auto written = [this](const char* name) {
            m_answers->file = path(name);
            trigger("file.exportHair");
            return std::size_t{qFromLittleEndian<quint32>(contentOf(path(name)).mid(4, 4).constData())};
        };
        // The worker has not seen the stroke yet.
        key(Qt::Key_1);
        drag(m_window->paintView(), paintPoint(0.45F, 0.5F), paintPoint(0.55F, 0.5F));
        const std::size_t painted = written("painted.hair");
        QVERIFY(painted > 100);
        awaitNewestHair();
        QCOMPARE(painted, hairs());
        // A style that is only pointed at is shown, and no part of it.
        const model::Result<model::Preset> style = model::loadPreset(model::listPresets({}).at(1).path);
        QVERIFY(style);
        model::EditSession pointedAt;
        session().document().show(pointedAt, {.policy = model::EditPolicy::Drop},
                                  {.aspect = model::Change::Aspect::GroupList},
                                  [&style](model::Project& project) { model::applyPreset(project, *style); });
        QTRY_VERIFY_WITH_TIMEOUT(session().frame()->preview && hairs() > 2 * painted, kPatienceMs);
        QCOMPARE(written("pointed at.hair"), painted);
        // Nor are the colours of a map that is looked at.
        session().lookAt(model::MapKind::Density);
        QTRY_VERIFY_WITH_TIMEOUT(session().frame()->preview, kPatienceMs);
        QCOMPARE(written("looked at.hair"), painted);
        QVERIFY(!session().frame()->preview);
    }

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

    void cancelledDialogsDoNothing_data()
    {
        QTest::addColumn<QByteArray>("action");
        for (const char* action : {"file.loadImage", "file.loadGrey", "file.saveImage", "file.importHead",
                                   "file.exportHair", "file.picture", "file.open", "file.saveAs"})
            QTest::newRow(action) << QByteArray(action);
    }
    void cancelledDialogsDoNothing()
    {
        QFETCH(QByteArray, action);
        open(model::newProject());
        const QByteArray before = savedBytes("cancel-before.hairpaint");
        trigger(action.constData());
        QCOMPARE(stack().count(), 0);
        QVERIFY(m_done.isEmpty() && m_answers->said.isEmpty());
        QVERIFY(savedBytes("cancel-after.hairpaint") == before);
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestExchange, Widgets)
#include "test_exchange.moc"
