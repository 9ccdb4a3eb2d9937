// The sliders of a group's settings: ranges keep what is painted, and a change is of the group it was made on.
#include "panel_fixture.h"

#include "model/document/paint_command.h"
#include "model/project/hair_types.h"
#include "tests/support/test_program.h"
#include "view/panels/hair_panel.h"

#include <QComboBox>
#include <QLineEdit>

#include <cmath>

using namespace hairpaint;
using namespace hairpaint::view;
using model::MapKind;

class TestGroupSliders : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void another_greatest_length_keeps_the_haircut()
    {
        model::Project project = smallProject();
        sim::TiledRaster& painted = project.groups.front().map(MapKind::Length).layers.front().raster;
        for (int index = 0; index < painted.tileCount(); ++index)
            painted.setUniform(index, {32768, 65535, 0, 0}); // 15 of 30 cm.
        model::Document document(project);
        EditorState state(document);
        HairPanel panel(state);
        panel.resize(280, 900);
        panel.show();
        QStringList told;
        connect(&state, &EditorState::told, this, [&told](const QString& text) { told.append(text); });
        const auto lengthCm = [&] {
            const model::HairGroup& group = document.project().groups.front();
            const auto texel = document.resolved(group.id, MapKind::Length)->texel(9, 9);
            return 100.0 * model::mapSpec(MapKind::Length).scale->amount(group.settings, texel[0] / 65535.0);
        };
        const auto type = [&](const QString& text) {
            BarSlider* slider = sliderNamed(panel, QStringLiteral("Greatest length"));
            slider->setFocus();
            QTest::keyClick(slider, Qt::Key_Return);
            auto* editor = slider->findChild<QLineEdit*>();
            editor->setText(text);
            QTest::keyClick(editor, Qt::Key_Return);
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        };
        const auto near = [](double a, double b) { return std::abs(a - b) < 0.01; };
        type(QStringLiteral("60 cm"));
        QVERIFY2(near(lengthCm(), 15.0), qPrintable(QString::number(lengthCm())));
        QCOMPARE(document.undoStack().count(), 1);
        QCOMPARE(document.undoStack().undoText(), QStringLiteral("Greatest length of \"Scalp\""));
        QVERIFY(told.isEmpty());
        type(QStringLiteral("100 mm"));
        QVERIFY(near(lengthCm(), 10.0));
        QCOMPARE(document.undoStack().count(), 2);
        QCOMPARE(told, QStringList(QStringLiteral("What was painted on Length beyond 10\u2009cm is 10\u2009cm now; "
                                                  "undo brings it back.")));
        document.undo();
        document.undo();
        QVERIFY(document.project().groups == project.groups);
        // While it moves it is the same.
        BarSlider* slider = sliderNamed(panel, QStringLiteral("Greatest length"));
        holdAt(*slider, 0.9);
        QVERIFY(document.previewing());
        QVERIFY(near(lengthCm(), 15.0));
        QTest::mouseClick(slider, Qt::RightButton);
        QVERIFY(document.project().groups == project.groups);
        QCOMPARE(document.undoStack().index(), 0);
    }

    void the_range_of_a_large_map_is_changed_when_it_is_let_go()
    {
        model::Project project;
        project.groups.push_back(model::makeGroup(project, QStringLiteral("Scalp"), 2048));
        sim::TiledRaster& painted = project.groups.front().map(MapKind::Length).layers.front().raster;
        for (int index = 0; index < painted.tileCount(); ++index) {
            const std::span<std::uint16_t> pixels = painted.writableTile(index);
            for (std::size_t i = 0; i < pixels.size(); i += 2) {
                pixels[i] = i == 0 ? 0 : 32768;
                pixels[i + 1] = 65535;
            }
        }
        model::Document document(project);
        EditorState state(document);
        HairPanel panel(state);
        panel.resize(280, 900);
        panel.show();
        BarSlider* slider = sliderNamed(panel, QStringLiteral("Greatest length"));
        holdAt(*slider, 0.9);
        QVERIFY(!document.previewing());
        letGo(*slider, QPoint(qRound(slider->width() * 0.9), 12));
        QCOMPARE(document.undoStack().count(), 1);
        const model::HairGroup& group = document.project().groups.front();
        QVERIFY(group.settings.greatestLengthM > 1.0F);
        const auto texel = group.map(MapKind::Length).layers.front().raster.texel(9, 9);
        const double lengthM = model::mapSpec(MapKind::Length).scale->amount(group.settings, texel[0] / 65535.0);
        QVERIFY(std::abs(lengthM - 0.15) < 1e-4);
        QVERIFY(std::abs(slider->value() - 100.0 * static_cast<double>(group.settings.greatestLengthM)) < 0.06);
    }

    void a_click_that_waits_for_its_double_is_of_the_group_it_was_made_on()
    {
        PanelFixture f;
        HairPanel panel(f.state);
        panel.resize(280, 900);
        panel.show();
        BarSlider* slider = sliderNamed(panel, QStringLiteral("Stands up to"));
        QVERIFY(slider != nullptr);
        const sim::GroupSettings beard = f.document.project().groups[1].settings;
        const sim::GroupSettings scalp = f.scalp().settings;
        QTest::mouseClick(slider, Qt::LeftButton, {}, QPoint(slider->width() * 9 / 10, 12));
        f.state.target().setGroup(f.document.project().groups[1].id);
        QVERIFY(!slider->editing());
        QVERIFY(f.document.project().groups[1].settings == beard);
        QVERIFY(!(f.scalp().settings == scalp));
        QCOMPARE(slider->value(), 5.0);
        QCOMPARE(f.steps(), 1);
    }

    void what_undo_took_back_while_a_click_waits_for_its_double_stays_so()
    {
        PanelFixture f;
        HairPanel panel(f.state);
        panel.resize(280, 900);
        panel.show();
        BarSlider* slider = sliderNamed(panel, QStringLiteral("Stands up to"));
        QVERIFY(slider != nullptr);
        const sim::GroupSettings before = f.scalp().settings;
        QTest::mouseClick(slider, Qt::LeftButton, {}, QPoint(slider->width() * 9 / 10, 12));
        f.document.undo();
        slider->release(); // As when the time for a second click is over.
        QVERIFY(f.scalp().settings == before);
        QCOMPARE(slider->value(), 5.0);
        QCOMPARE(f.steps(), 0);
    }

    void a_hair_type_sets_the_curl_in_one_step()
    {
        PanelFixture f;
        HairPanel panel(f.state);
        panel.resize(280, 900);
        panel.show();
        auto* types = panel.findChild<QComboBox*>(QStringLiteral("hairType"));
        QVERIFY(types != nullptr);
        const auto count = static_cast<int>(model::hairTypes().size());
        QCOMPARE(types->currentIndex(), count); // Its numbers are of no type,
        BarSlider* diameter = sliderNamed(panel, QStringLiteral("Coil diameter"));
        QVERIFY(diameter != nullptr && !diameter->isVisibleTo(&panel)); // and not those of coils.
        const sim::GroupSettings before = f.scalp().settings;
        QTest::keyClick(types, Qt::Key_Home);
        QTest::keyClick(types, Qt::Key_Down);
        QCOMPARE(f.steps(), 2);
        QVERIFY(f.scalp().settings.turnsMode == sim::TurnsMode::Coils);
        QVERIFY(f.scalp().settings.curl == model::hairType("1B").curl);
        QCOMPARE(types->count(), count);
        QVERIFY(diameter->isVisibleTo(&panel));
        holdAt(*diameter, 0.8);
        letGo(*diameter, QPoint(1, 12));
        QCOMPARE(types->currentIndex(), count);
        QCOMPARE(types->count(), count + 1);
        f.document.undo();
        QCOMPARE(types->currentText(), QStringLiteral("1B"));
        f.document.undo();
        f.document.undo();
        QVERIFY(f.scalp().settings == before);
    }

    void a_curled_hair_type_is_seen_at_once_where_no_curl_is_painted()
    {
        PanelFixture f;
        HairPanel panel(f.state);
        panel.show();
        auto* types = panel.findChild<QComboBox*>(QStringLiteral("hairType"));
        const auto curl = [&] { return f.document.resolved(f.scalp().id, MapKind::Curl)->texel(9, 9)[0]; };
        const model::MapStack before = f.scalp().map(MapKind::Curl);
        QCOMPARE(curl(), 0);
        QTest::keyClick(types, Qt::Key_Home); // 1A has no curl to be seen,
        QCOMPARE(curl(), 0);
        types->setCurrentIndex(7);
        QTest::keyClick(types, Qt::Key_Down);
        QCOMPARE(types->currentText(), QStringLiteral("3C")); // 3C has.
        QCOMPARE(curl(), 65535);
        QCOMPARE(f.steps(), 2);
        f.document.undo();
        QVERIFY(f.scalp().map(MapKind::Curl) == before);
        QCOMPARE(types->currentText(), QStringLiteral("1A"));
    }

    void a_hair_type_keeps_curl_that_is_painted()
    {
        PanelFixture f;
        const model::Layer& layer = f.scalp().map(MapKind::Curl).layers.front();
        sim::TiledRaster painted = layer.raster;
        painted.setTexel(5, 6, {20000, 65535});
        f.document.push(model::paintCommand(f.document, {f.scalp().id, MapKind::Curl, layer.id}, {{0, painted.tile(0)}},
                                            QStringLiteral("Brush")));
        const model::MapStack before = f.scalp().map(MapKind::Curl);
        HairPanel panel(f.state);
        panel.show();
        auto* types = panel.findChild<QComboBox*>(QStringLiteral("hairType"));
        types->setCurrentIndex(7);
        QTest::keyClick(types, Qt::Key_Down);
        QVERIFY(f.scalp().settings.turnsMode == sim::TurnsMode::Coils);
        QVERIFY(f.scalp().map(MapKind::Curl) == before);
    }

    void a_brush_paints_as_much_curl_where_turns_become_per_cent()
    {
        PanelFixture f;
        f.state.target().setMap(MapKind::Curl);
        HairPanel panel(f.state);
        panel.resize(280, 900);
        panel.show();
        const float painted = f.state.tools().settings().value(MapKind::Curl).scalar;
        auto* types = panel.findChild<QComboBox*>(QStringLiteral("hairType"));
        QTest::keyClick(types, Qt::Key_Home);
        QTest::keyClick(types, Qt::Key_End);
        QVERIFY(f.scalp().settings.turnsMode == sim::TurnsMode::Coils);
        QCOMPARE(f.state.tools().settings().value(MapKind::Curl).scalar, painted);
    }
};

HAIRPAINT_TEST(TestGroupSliders, Widgets)
#include "test_group_sliders.moc"
