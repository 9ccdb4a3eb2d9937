// Hair that goes out to other programs by the window's menus and dialogs, and its cards, looked at before.
#include "model/document/layer_commands.h"
#include "model/files/glb_writing.h"
#include "model/files/head_file.h"
#include "model/files/preset_file.h"
#include "model/styles/preset.h"
#include "tests/app/exchange_fixture.h"
#include "tests/app/program.h"
#include "tests/app/thin_project.h"
#include "tests/support/glb_json.h"
#include "tests/support/head_picture.h"
#include "tests/support/mannequin.h"
#include "tests/support/test_program.h"
#include "view/head_area/view_signs.h"
#include "view/rendering/card_set.h"
#include "view/widgets/bar_slider.h"

#include <QComboBox>
#include <QTimer>

namespace hairpaint::app {

using test::contentOf;

class TestHairExchange : public QObject, private ExchangeFixture
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { prepareDialogs(); }
    void cleanup() { closeWindow(); }

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

    void hairGoesOutAsTheDialogSays_data()
    {
        QTest::addColumn<int>("source");
        QTest::newRow("now") << static_cast<int>(view::HairSource::Now);
        QTest::newRow("settled") << static_cast<int>(view::HairSource::Settled);
        QTest::newRow("rest") << static_cast<int>(view::HairSource::Rest);
    }
    void hairGoesOutAsTheDialogSays()
    {
        QFETCH(int, source);
        open(test::thinned(starterProject()));
        awaitNewestHair();
        m_answers->file = path("chosen"); // The ending comes from the dialog.
        m_answers->choosesExport = [source](view::ExportHairDialog& dialog) {
            const QList<QComboBox*> boxes = dialog.findChildren<QComboBox*>();
            QTest::keyClick(boxes[0], Qt::Key_Down);
            boxes[2]->setCurrentIndex(source);
        };
        trigger("file.exportHair");
        QCOMPARE(m_done, QStringList(QStringLiteral("chosen.usda written")));
        const QByteArray usd = contentOf(path("chosen.usda"));
        QVERIFY(usd.startsWith("#usda 1.0") && usd.contains("def Xform \"Scalp\""));
        QVERIFY(QFile::remove(path("chosen.usda")));
    }

    void cardsAreSeenBeforeTheyAreWritten_data()
    {
        QTest::addColumn<bool>("fromDialog");
        QTest::newRow("from the menu") << false;
        QTest::newRow("from the dialog") << true;
    }
    void cardsAreSeenBeforeTheyAreWritten()
    {
        QFETCH(bool, fromDialog);
        open(test::thinned(starterProject()));
        awaitNewestHair();
        view::HeadView& head = m_window->headView();
        const QImage strands = test::pictureOf(head, {200, 200});
        m_answers->file = path("unwritten.glb");
        m_answers->choosesExport = [](view::ExportHairDialog& dialog) {
            QComboBox* format = dialog.findChildren<QComboBox*>()[0];
            format->setCurrentIndex(static_cast<int>(&model::cardFormat() - model::exportFormats().data()));
            dialog.findChildren<view::BarSlider*>()[2]->setValue(3000.0);
            for (QPushButton* button : dialog.findChildren<QPushButton*>())
                if (button->text() == QStringLiteral("Pre&view"))
                    button->click();
        };
        if (fromDialog) {
            trigger("file.exportHair", Beside::Leave);
            auto* dialog = m_window->findChild<view::ExportHairDialog*>();
            QVERIFY(dialog != nullptr && !dialog->isModal());
            m_answers->choosesExport(*dialog);
            QVERIFY(dialog->isVisible()); // Other cards can be asked for while these are looked at.
        } else {
            trigger("view.cards");
        }
        QVERIFY2(m_answers->said.isEmpty(), qPrintable(m_answers->said.join(QLatin1Char('\n'))));
        QVERIFY(head.cardsShown() && action("view.cards")->isChecked());
        QVERIFY(m_done.isEmpty() && !QFile::exists(path("unwritten.glb")));
        const std::size_t triangles = head.pictureScene().cards->triangles.size();
        QVERIFY2(triangles > 500 && triangles <= (fromDialog ? 3000U : 15'000U),
                 qPrintable(QString::number(triangles)));
        const QString sign = head.findChild<view::ViewSigns*>()->text();
        QVERIFY2(sign.contains(QStringLiteral("%L1 triangles").arg(triangles)), qPrintable(sign));
        const QImage cards = test::pictureOf(head, {200, 200});
        QVERIFY(cards != strands);

        if (fromDialog) {
            // They can be turned, and others asked for, while the dialog is open.
            auto* dialog = m_window->findChild<view::ExportHairDialog*>();
            head.setView(rendering::StandardView::Back);
            dialog->findChildren<view::BarSlider*>()[2]->setValue(1500.0);
            Q_EMIT dialog->previewWanted();
            QVERIFY(head.pictureScene().cards->triangles.size() < triangles);
            QVERIFY(dialog->isVisible());
            QTest::keyClick(dialog, Qt::Key_Escape);
            QVERIFY(!dialog->isVisible() && head.cardsShown());
        }

        trigger("view.cards", Beside::Leave);
        QVERIFY(!head.cardsShown() && !action("view.cards")->isChecked());
        trigger("view.cards", Beside::Leave);
        QVERIFY(head.cardsShown());
        key(Qt::Key_1);
        drag(m_window->paintView(), paintPoint(0.45F, 0.5F), paintPoint(0.55F, 0.5F));
        QTRY_VERIFY_WITH_TIMEOUT(!head.cardsShown(), kPatienceMs);
    }

    void aBodyGoesOutAsAnAvatar()
    {
        model::Project project = test::thinned(starterProject());
        project.head = model::makeHead(QStringLiteral("Mannequin"), model::glbFromMesh(test::makeMannequin()), 1.0F,
                                       model::UpAxis::Y)
                           .value();
        open(project);
        awaitNewestHair();
        m_answers->file = path("Ann"); // The ending comes from the dialog.
        QString author = QStringLiteral("Zoë");
        QString before;
        m_answers->choosesExport = [&author, &before](view::ExportHairDialog& dialog) {
            QComboBox* format = dialog.findChildren<QComboBox*>()[0];
            format->setCurrentIndex(format->count() - 1);
            dialog.findChildren<QComboBox*>()[3]->setCurrentIndex(0);
            auto* field = dialog.findChild<QLineEdit*>({}, Qt::FindDirectChildrenOnly);
            before = field->text();
            field->setText(author);
        };
        trigger("file.exportHair");
        QVERIFY2(m_answers->said.isEmpty(), qPrintable(m_answers->said.join(QLatin1Char('\n'))));
        QCOMPARE(m_done, QStringList(QStringLiteral("Ann.vrm written")));
        const QJsonObject json = test::jsonOf(contentOf(path("Ann.vrm")));
        const QJsonValue meta = json[QLatin1String("extensions")][QLatin1String("VRMC_vrm")][QLatin1String("meta")];
        QCOMPARE(meta[QLatin1String("name")].toString(), QStringLiteral("Ann"));
        QCOMPARE(meta[QLatin1String("authors")].toArray(), QJsonArray{author});
        // A project that has a file gives its name, as from the command line.
        m_answers->file = path("hero.hairpaint");
        trigger("file.saveAs");
        m_answers->file = path("Bea");
        trigger("file.exportHair");
        QCOMPARE(before, author); // It is remembered.
        const QJsonObject saved = test::jsonOf(contentOf(path("Bea.vrm")));
        QCOMPARE(
            saved[QLatin1String("extensions")][QLatin1String("VRMC_vrm")][QLatin1String("meta")][QLatin1String("name")]
                .toString(),
            QStringLiteral("hero"));
    }

    void aHeadAloneIsNoAvatar()
    {
        open(test::thinned(starterProject()));
        awaitNewestHair();
        m_answers->file = path("bust.vrm"); // Another format than the dialog's.
        m_answers->choosesExport = nullptr;
        trigger("file.exportHair");
        QCOMPARE(m_answers->said.size(), qsizetype{1});
        QVERIFY2(m_answers->said.front().contains(QStringLiteral("skeleton")), qPrintable(m_answers->said.front()));
        QVERIFY(m_done.isEmpty() && !QFile::exists(path("bust.vrm")));
    }

    void cardsCanBeCancelled()
    {
        open(starterProject());
        awaitNewestHair();
        m_answers->cancels = true;
        trigger("view.cards");
        if (m_answers->cancelled == 0)
            return; // They were made before there was anything to click.
        QVERIFY(m_answers->said.isEmpty() && !m_window->headView().cardsShown());
        QVERIFY(!action("view.cards")->isChecked());
    }

    void anExportCanBeCancelled()
    {
        open(starterProject());
        awaitNewestHair();
        m_answers->file = path("cancelled.obj");
        m_answers->cancels = true;
        m_answers->choosesExport = [](view::ExportHairDialog& dialog) {
            dialog.findChildren<QComboBox*>()[2]->setCurrentIndex(static_cast<int>(view::HairSource::Settled));
        };
        trigger("file.exportHair");
        if (m_answers->cancelled == 0)
            return; // It was done before there was anything to click.
        QVERIFY(m_answers->said.isEmpty());
        QCOMPARE(QFile::exists(path("cancelled.obj")), !m_done.isEmpty());
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

    void theHairThatGoesOutWaitsForMapsThatAreResolved()
    {
        // Full density under a layer that hides all of it; no tile is one value.
        constexpr int kLargeMap = 2048;
        model::Project project = model::newProject();
        const model::Id group = project.groups.front().id;
        model::MapStack& density = project.groups.front().map(model::MapKind::Density);
        density.size = kLargeMap;
        density.layers.clear();
        for (const std::uint16_t value : {std::uint16_t{65535}, std::uint16_t{0}}) {
            model::Layer layer =
                model::makeLayer(project, model::mapSpec(density.kind), kLargeMap, QStringLiteral("Layer"));
            for (int tile = 0; tile < layer.raster.tileCount(); ++tile) {
                layer.raster.setUniform(tile, {value, 65535});
                layer.raster.writableTile(tile)[1] = 65534;
            }
            density.layers.push_back(std::move(layer));
        }
        const model::Id hiding = density.layers.back().id;
        open(std::move(project));
        QTRY_VERIFY_WITH_TIMEOUT(!session().document().resolving(), kPatienceMs);
        const model::LayerAddress at{group, model::MapKind::Density, hiding};
        model::Document& document = session().document();
        model::LayerProperties properties =
            model::propertiesOf(*document.committed().layer(at.group, at.map, at.layer));
        properties.visible = false;
        // The background gets to it when the export has waited so long that a window tells of it.
        std::function<void()> resolve;
        document.resolveIn([&resolve](const std::function<void()>& work, const std::function<void(bool)>& done) {
            resolve = [work, done] {
                work();
                done(true);
            };
        });
        document.push(model::setLayerPropertiesCommand(document, at, properties, QString()));
        QVERIFY(document.resolving());
        QTimer watch;
        connect(&watch, &QTimer::timeout, this, [&] {
            const QWidget* waiting = QApplication::activeModalWidget();
            if (waiting != nullptr && waiting->objectName() == QLatin1String("progressWindow") && document.resolving())
                std::exchange(resolve, {})();
        });
        watch.start(10);
        m_answers->file = path("shown.hair");
        trigger("file.exportHair");
        QVERIFY(!document.resolving());
        QVERIFY(qFromLittleEndian<quint32>(contentOf(path("shown.hair")).mid(4, 4).constData()) > 5000);
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestHairExchange, Widgets)
#include "test_hair_exchange.moc"
