// Wind and light are shown live and are one undo step; import, preferences and keys.
#include "panel_fixture.h"

#include "model/document/scene_commands.h"
#include "tests/support/test_heads.h"
#include "tests/support/test_program.h"
#include "view/dialogs/head_import_dialog.h"
#include "view/dialogs/light_dialog.h"
#include "view/dialogs/preferences_dialog.h"
#include "view/dialogs/scale_hair_dialog.h"
#include "view/dialogs/wind_dialog.h"
#include "view/widgets/direction_ball.h"
#include "view/widgets/swatch.h"

#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTreeWidget>

#include <cmath>

using namespace hairpaint;
using namespace hairpaint::view;

namespace {

QPushButton* buttonWith(const QWidget& parent, const QString& text)
{
    for (QPushButton* button : parent.findChildren<QPushButton*>())
        if (button->text() == text)
            return button;
    return nullptr;
}

QTreeWidgetItem* rowOf(const QTreeWidget& tree, const QString& text)
{
    const auto found = tree.findItems(text, Qt::MatchExactly | Qt::MatchRecursive, 0);
    return found.isEmpty() ? nullptr : found.first();
}

} // namespace

class TestDialogs : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void wind_strength_is_live_and_one_step()
    {
        PanelFixture f;
        WindDialog dialog(f.state);
        dialog.show();
        const sim::Wind before = f.document.project().wind;
        BarSlider* strength = sliderNamed(dialog, QStringLiteral("Strength"));
        QCOMPARE(strength->value(), 5.0);
        holdAt(*strength, 0.9);
        QVERIFY(f.document.previewing());
        const sim::Wind shown = f.document.project().wind;
        QVERIFY(glm::length(shown.velocity) > 20.0F);
        QVERIFY(glm::length(glm::normalize(shown.velocity) - glm::vec3(0.6F, 0.0F, 0.8F)) < 1e-5F);
        dragTo(*strength, QPoint(qRound(strength->width() * 0.9), 12));
        QCOMPARE(f.steps(), 0);
        letGo(*strength, QPoint(10, 12));
        QCOMPARE(f.steps(), 1);
        QVERIFY(f.document.project().wind == shown);
        f.document.undo();
        QVERIFY(f.document.project().wind == before);
        QCOMPARE(strength->value(), 5.0);
    }

    void touching_one_control_leaves_the_others_exact()
    {
        PanelFixture f;
        f.document.apply({.aspect = model::Change::Aspect::Environment}, [](model::Project& project) {
            project.wind.velocity = {1.2345F, 0.777F, -2.3456F};
        });
        WindDialog dialog(f.state);
        dialog.show();
        BarSlider* gusts = sliderNamed(dialog, QStringLiteral("Gusts"));
        holdAt(*gusts, 0.9);
        letGo(*gusts);
        QVERIFY(f.document.project().wind.velocity == glm::vec3(1.2345F, 0.777F, -2.3456F));
    }

    void the_ball_turns_the_wind_and_escape_takes_it_back()
    {
        PanelFixture f;
        WindDialog dialog(f.state);
        dialog.show();
        auto* ball = dialog.findChild<DirectionBall*>();
        QTest::mousePress(ball, Qt::LeftButton, {}, ball->rect().center());
        dragTo(*ball, QPoint(4, ball->height() / 2));
        QVERIFY(f.document.project().wind.velocity.x < -4.0F);
        QVERIFY(std::abs(glm::length(f.document.project().wind.velocity) - 5.0F) < 1e-3F);
        QTest::keyClick(ball, Qt::Key_Escape);
        QCOMPARE(f.document.project().wind.velocity.x, 3.0F);
        QVERIFY(!f.document.previewing());
        letGo(*ball);
        QCOMPARE(f.steps(), 0);
        QTest::keyClick(ball, Qt::Key_Up);
        QCOMPARE(f.steps(), 1);
        QVERIFY(f.document.project().wind.velocity.y > 0.1F);
        QTest::mouseDClick(ball, Qt::LeftButton, {}, QPoint(4, ball->height() / 2));
        QVERIFY(f.document.project().wind.velocity.z < 0.0F);
    }

    void wind_is_switched_off_and_on_without_a_step()
    {
        PanelFixture f;
        WindDialog dialog(f.state);
        dialog.show();
        auto* blows = dialog.findChild<QCheckBox*>();
        blows->click();
        QVERIFY(!f.document.project().wind.enabled);
        QCOMPARE(f.steps(), 0);
        QVERIFY(!f.document.modified());
        f.document.setWindOn(true);
        QVERIFY(blows->isChecked());
    }

    void every_light_control_is_one_step()
    {
        PanelFixture f;
        LightDialog dialog(f.state);
        dialog.show();
        const model::LightSettings before = f.document.project().light;
        int steps = 0;
        for (BarSlider* slider : dialog.findChildren<BarSlider*>()) {
            const model::LightSettings last = f.document.project().light;
            holdAt(*slider, 0.15);
            QVERIFY2(!(f.document.project().light == last), qPrintable(slider->label()));
            const model::LightSettings shown = f.document.project().light;
            letGo(*slider);
            QCOMPARE(f.steps(), ++steps);
            QVERIFY(f.document.project().light == shown);
        }
        QCOMPARE(steps, 7);
        while (f.document.undoStack().canUndo())
            f.document.undo();
        QVERIFY(f.document.project().light == before);
    }

    void the_lights_colour_has_one_control()
    {
        PanelFixture f;
        LightDialog dialog(f.state);
        dialog.show();
        for (const char* doubled : {"Red", "Green", "Blue"})
            QVERIFY(sliderNamed(dialog, QString::fromLatin1(doubled)) == nullptr);
        const auto swatches = dialog.findChildren<Swatch*>();
        const auto found = std::ranges::find(swatches, QStringLiteral("Light colour"), &Swatch::accessibleName);
        QVERIFY(found != swatches.end());
        Swatch& colour = **found;
        // It shows what others set, in numbers too.
        model::LightSettings tinted = f.document.project().light;
        tinted.red = 1.0F;
        tinted.green = 0.5F;
        tinted.blue = 0.25F;
        f.document.push(model::setLightCommand(f.document, tinted));
        QCOMPARE(colour.colour().red(), 255);
        QVERIFY(colour.colour().blue() < colour.colour().green());
        const auto labels = dialog.findChildren<QLabel*>();
        QVERIFY(std::ranges::any_of(
            labels, [](const QLabel* label) { return label->text() == QStringLiteral("R 100  G 50  B 25 %"); }));
        // A colour that is chosen is seen at once and is one step.
        const int before = f.steps();
        colour.click();
        auto* picker = dialog.findChild<QColorDialog*>();
        QVERIFY(picker != nullptr);
        picker->setCurrentColor(QColor(255, 255, 0));
        QCOMPARE(f.document.project().light.blue, 0.0F);
        QVERIFY(f.document.previewing());
        picker->accept();
        QCOMPARE(f.steps(), before + 1);
        QCOMPARE(f.document.project().light.blue, 0.0F);
        // As with bars, the right button takes it back to what is usual.
        Q_EMIT colour.customContextMenuRequested({});
        QCOMPARE(f.steps(), before + 2);
        QCOMPARE(f.document.project().light.blue, 1.0F);
    }

    void light_presets_and_choices_are_one_step_each()
    {
        PanelFixture f;
        LightDialog dialog(f.state);
        dialog.show();
        const model::LightSettings before = f.document.project().light;
        int steps = 0;
        for (QComboBox* box : dialog.findChildren<QComboBox*>()) {
            box->setCurrentIndex(1);
            Q_EMIT box->activated(1);
            QCOMPARE(f.steps(), ++steps);
        }
        QCOMPARE(f.document.project().light.surroundings, model::Surroundings::Daylight);
        QCOMPARE(f.document.project().light.scattering, model::Scattering::KajiyaKay);
        for (const model::LightPreset& preset : model::lightPresets()) {
            const auto buttons = dialog.findChildren<QPushButton*>();
            const auto button = std::ranges::find(buttons, preset.titleText(), &QPushButton::text);
            QVERIFY(button != buttons.end());
            (*button)->click();
            QCOMPARE(f.steps(), ++steps);
            QVERIFY(f.document.project().light == preset.appliedTo(f.document.project().light));
            QCOMPARE(f.document.project().light.scattering, model::Scattering::KajiyaKay);
        }
        while (f.document.undoStack().canUndo())
            f.document.undo();
        QVERIFY(f.document.project().light == before);
    }

    void directions_and_angles_agree_data()
    {
        QTest::addColumn<double>("azimuth");
        QTest::addColumn<double>("elevation");
        QTest::newRow("front") << 0.0 << 0.0;
        QTest::newRow("right and up") << 1.2 << 0.7;
        QTest::newRow("behind left") << -2.8 << -0.4;
    }
    void directions_and_angles_agree()
    {
        QFETCH(double, azimuth);
        QFETCH(double, elevation);
        const glm::vec3 direction = DirectionBall::fromAngles(azimuth, elevation);
        QVERIFY(std::abs(glm::length(direction) - 1.0F) < 1e-6F);
        QVERIFY(std::abs(DirectionBall::azimuthRad(direction) - azimuth) < 1e-6);
        QVERIFY(std::abs(DirectionBall::elevationRad(direction) - elevation) < 1e-6);
    }

    void an_imported_head_shows_its_height_and_takes_another_data()
    {
        QTest::addColumn<float>("scale");
        QTest::newRow("metres") << 1.0F;
        QTest::newRow("centimetres") << 100.0F;
        QTest::newRow("millimetres") << 1000.0F;
    }
    void an_imported_head_shows_its_height_and_takes_another()
    {
        QFETCH(float, scale);
        sim::HeadMesh mesh = test::makeBallHead();
        const float tall = [&] {
            float low = 1e9F;
            float high = -1e9F;
            for (const glm::vec3& position : mesh.positionsHd) {
                low = std::min(low, position.y);
                high = std::max(high, position.y);
            }
            return high - low;
        }();
        for (glm::vec3& position : mesh.positionsHd)
            position *= scale * 0.25F / tall;
        HeadImportDialog dialog(mesh, QStringLiteral("head.obj"));
        QVERIFY(std::abs(dialog.heightCm() - 25.0) < 0.5);
        QVERIFY(std::abs(dialog.unitScale() * scale - 1.0F) < 1e-3F);
        BarSlider* height = sliderNamed(dialog, QStringLiteral("Height"));
        dialog.show();
        const float unit = dialog.unitScale();
        const QPoint there(height->width() * 9 / 10, 12);
        QTest::mouseClick(height, Qt::LeftButton, {}, there);
        QTest::mouseDClick(height, Qt::LeftButton, {}, there);
        QCOMPARE(dialog.unitScale(), unit); // A double click types; it sets nothing.
        QTest::keyClick(height->findChild<QLineEdit*>(), Qt::Key_Escape);
        holdAt(*height, 0.5);
        letGo(*height);
        QVERIFY(std::abs(dialog.heightCm() - height->value()) < 0.1);
        QVERIFY(dialog.heightCm() > 50.0);
    }

    void what_a_file_tells_of_its_unit_and_axis_is_taken_and_said()
    {
        model::RiggedMesh mesh(test::makeBallHead());
        mesh.told = {.metresPerUnit = 0.1F, .up = model::ToldAxis::Y};
        for (glm::vec3& position : mesh.positionsHd)
            position *= 10.0F;
        HeadImportDialog dialog(mesh, QStringLiteral("head.fbx"));
        const auto isSaid = [&dialog] {
            return std::ranges::any_of(dialog.findChildren<QLabel*>(), [](const QLabel* label) {
                return label->text().contains(QStringLiteral("that the file tells"));
            });
        };
        QCOMPARE(dialog.unitScale(), 0.1F);
        QVERIFY(isSaid());
        dialog.findChildren<QComboBox*>().at(0)->setCurrentIndex(1);
        QVERIFY(!isSaid()); // The user says otherwise.
    }

    void hair_is_scaled_by_a_percentage_in_one_step()
    {
        PanelFixture f;
        const model::HairGroup before = f.scalp();
        {
            ScaleHairDialog dialog(f.state);
            dialog.show();
            holdAt(*sliderNamed(dialog, QStringLiteral("Length")), 0.9);
            QVERIFY(f.scalp().settings.greatestLengthM > 0.3F);
            dialog.reject();
        }
        QVERIFY(f.scalp() == before);
        QCOMPARE(f.steps(), 0);
        ScaleHairDialog dialog(f.state);
        dialog.show();
        const auto type = [&](const QString& label, const QString& text) {
            BarSlider* slider = sliderNamed(dialog, label);
            slider->setFocus();
            QTest::keyClick(slider, Qt::Key_Return);
            auto* editor = slider->findChild<QLineEdit*>();
            editor->setText(text);
            QTest::keyClick(editor, Qt::Key_Return);
        };
        type(QStringLiteral("Length"), QStringLiteral("150 %"));
        type(QStringLiteral("Curl size"), QStringLiteral("200"));
        QVERIFY(f.document.previewing());
        dialog.accept();
        QCOMPARE(f.steps(), 1);
        QCOMPARE(f.document.undoStack().undoText(), QStringLiteral("Scale the hair of \"Scalp\""));
        QCOMPARE(f.scalp().settings.greatestLengthM, 0.45F);
        QCOMPARE(f.scalp().settings.greatestCurlRadiusM, 0.024F);
        QCOMPARE(f.scalp().settings.greatestDensityPerM2, before.settings.greatestDensityPerM2);
        QVERIFY(f.scalp().maps == before.maps);
        f.document.undo();
        QVERIFY(f.scalp() == before);
    }

    void a_mesh_without_uv_is_refused_with_the_reason()
    {
        sim::HeadMesh mesh = test::makeBallHead();
        QVERIFY(HeadImportDialog::refusal(mesh, QStringLiteral("a.obj")).isEmpty());
        mesh.uvs.assign(mesh.uvs.size(), glm::vec2(0.0F));
        HeadImportDialog dialog(mesh, QStringLiteral("a.obj"));
        QVERIFY(!dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->isEnabled());
        bool said = false;
        for (const QLabel* label : dialog.findChildren<QLabel*>())
            said = said || label->text().contains(QStringLiteral("UV"));
        QVERIFY(said);
        mesh.triangles.clear();
        QVERIFY(!HeadImportDialog::refusal(mesh, QStringLiteral("a.obj")).isEmpty());
    }

    void preferences_are_told_at_once_and_only_when_changed()
    {
        PreferencesDialog dialog({}, {{QStringLiteral("de"), QStringLiteral("Deutsch")}}, {});
        QSignalSpy changed(&dialog, &PreferencesDialog::preferencesChanged);
        dialog.setPreferences(
            {.theme = ThemeKind::Light, .language = {}, .presenter = {}, .whitePaper = true, .earlierVersions = true});
        QCOMPARE(changed.count(), 0);
        dialog.findChild<QComboBox*>()->setCurrentIndex(0);
        QCOMPARE(changed.count(), 1);
        QVERIFY(dialog.preferences().theme == ThemeKind::Dark);
        QVERIFY(dialog.preferences().whitePaper);
        QVERIFY(dialog.preferences().earlierVersions);
    }

    void a_key_is_rebound_and_taken_from_its_owner()
    {
        QAction brush(QStringLiteral("&Brush"));
        brush.setShortcut(QKeySequence(Qt::Key_B));
        QAction eraser(QStringLiteral("&Eraser"));
        eraser.setShortcut(QKeySequence(Qt::Key_E));
        PreferencesDialog dialog({}, {},
                                 {{&brush, QStringLiteral("Tools"), QStringLiteral("Brush"), {Qt::Key_B}},
                                  {&eraser, QStringLiteral("Tools"), QStringLiteral("Eraser"), {Qt::Key_E}}});
        dialog.show();
        QSignalSpy changed(&dialog, &PreferencesDialog::keyChanged);
        auto* tree = dialog.findChild<QTreeWidget*>();
        tree->setCurrentItem(rowOf(*tree, QStringLiteral("Brush")));
        dialog.findChild<QKeySequenceEdit*>()->setKeySequence(QKeySequence(Qt::Key_E));
        buttonWith(dialog, QStringLiteral("Assign"))->click();
        QCOMPARE(brush.shortcut(), QKeySequence(Qt::Key_E));
        QVERIFY(eraser.shortcut().isEmpty());
        QCOMPARE(changed.count(), 2);
        buttonWith(dialog, QStringLiteral("Reset"))->click();
        QCOMPARE(brush.shortcut(), QKeySequence(Qt::Key_B));
        QCOMPARE(rowOf(*tree, QStringLiteral("Brush"))->text(1), QStringLiteral("B"));
        QCOMPARE(eraser.shortcut(), QKeySequence(Qt::Key_E)); // It had lost its key to the brush.
        QCOMPARE(rowOf(*tree, QStringLiteral("Eraser"))->text(1), QStringLiteral("E"));
    }

    void resetting_a_key_leaves_nobody_without_one()
    {
        QAction brush(QStringLiteral("&Brush"));
        brush.setShortcut(QKeySequence(Qt::Key_E));
        QAction eraser(QStringLiteral("&Eraser"));
        eraser.setShortcut(QKeySequence(Qt::Key_B));
        PreferencesDialog dialog({}, {},
                                 {{&brush, QStringLiteral("Tools"), QStringLiteral("Brush"), {Qt::Key_B}},
                                  {&eraser, QStringLiteral("Tools"), QStringLiteral("Eraser"), {Qt::Key_E}}});
        dialog.show();
        auto* tree = dialog.findChild<QTreeWidget*>();
        tree->setCurrentItem(rowOf(*tree, QStringLiteral("Brush")));
        buttonWith(dialog, QStringLiteral("Reset"))->click();
        QCOMPARE(brush.shortcut(), QKeySequence(Qt::Key_B));
        QCOMPARE(eraser.shortcut(), QKeySequence(Qt::Key_E));
    }

    void whoever_loses_a_key_by_a_reset_gets_all_its_own_ones_back()
    {
        const QList<QKeySequence> both{Qt::CTRL | Qt::SHIFT | Qt::Key_Z, Qt::CTRL | Qt::Key_Y};
        QAction brush(QStringLiteral("&Brush"));
        QAction redo(QStringLiteral("&Redo"));
        redo.setShortcut(QKeySequence(Qt::Key_B));
        PreferencesDialog dialog({}, {},
                                 {{&brush, QStringLiteral("Tools"), QStringLiteral("Brush"), {Qt::Key_B}},
                                  {&redo, QStringLiteral("Edit"), QStringLiteral("Redo"), both}});
        dialog.show();
        QSignalSpy reset(&dialog, &PreferencesDialog::keyReset);
        auto* tree = dialog.findChild<QTreeWidget*>();
        tree->setCurrentItem(rowOf(*tree, QStringLiteral("Brush")));
        buttonWith(dialog, QStringLiteral("Reset"))->click();
        QCOMPARE(brush.shortcut(), QKeySequence(Qt::Key_B));
        QCOMPARE(redo.shortcuts(), both);
        QCOMPARE(reset.count(), 2); // Both are as they were: nothing is to be remembered.
    }

    void all_keys_are_reset_at_once()
    {
        QAction redo(QStringLiteral("&Redo Brush on Length"));
        redo.setShortcut(QKeySequence(Qt::Key_R));
        QAction eraser(QStringLiteral("&Eraser"));
        const QList<QKeySequence> both{Qt::CTRL | Qt::SHIFT | Qt::Key_Z, Qt::CTRL | Qt::Key_Y};
        PreferencesDialog dialog({}, {},
                                 {{&redo, QStringLiteral("Edit"), QStringLiteral("Redo"), both},
                                  {&eraser, QStringLiteral("Tools"), QStringLiteral("Eraser"), {Qt::Key_E}}});
        dialog.show();
        QSignalSpy reset(&dialog, &PreferencesDialog::keyReset);
        // What an action would do just now is no part of its name.
        QVERIFY(rowOf(*dialog.findChild<QTreeWidget*>(), QStringLiteral("Redo")) != nullptr);
        QVERIFY(buttonWith(dialog, QStringLiteral("Reset all"))->isEnabled());
        buttonWith(dialog, QStringLiteral("Reset all"))->click();
        QCOMPARE(redo.shortcuts(), both);
        QCOMPARE(eraser.shortcut(), QKeySequence(Qt::Key_E));
        QCOMPARE(reset.count(), 2);
        QVERIFY(!buttonWith(dialog, QStringLiteral("Reset all"))->isEnabled());
    }
};

HAIRPAINT_TEST(TestDialogs, Widgets)
#include "test_dialogs.moc"
