// The dialog of the export, by mouse and keys.
#include "panel_fixture.h"

#include "tests/support/test_program.h"
#include "view/dialogs/export_hair_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>

#include <QtTest>

#include <algorithm>

using namespace hairpaint;
using namespace hairpaint::view;

namespace {

std::vector<ExportableGroup> twoGroups()
{
    return {{.id = 3, .name = QStringLiteral("Scalp"), .hairs = 9000},
            {.id = 5, .name = QStringLiteral("Brows"), .hairs = 1000}};
}

QComboBox* boxAt(const ExportHairDialog& dialog, qsizetype index)
{
    return dialog.findChildren<QComboBox*>().at(index);
}

void type(BarSlider& slider, const QString& text)
{
    QTest::keyClick(&slider, Qt::Key_Return);
    auto* line = slider.findChild<QLineEdit*>();
    QVERIFY(line != nullptr);
    line->selectAll();
    QTest::keyClicks(line, text);
    QTest::keyClick(line, Qt::Key_Return);
}

/// Not that of the bones.
QList<QCheckBox*> groupBoxes(const ExportHairDialog& dialog)
{
    QList<QCheckBox*> boxes = dialog.findChildren<QCheckBox*>();
    boxes.removeIf([&dialog](const QCheckBox* box) { return box->parent() == &dialog; });
    return boxes;
}

QPushButton* acceptButton(const ExportHairDialog& dialog)
{
    return dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
}

} // namespace

class TestExportHairDialog : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void at_first_all_hair_goes_out_as_it_is_now()
    {
        const ExportHairDialog dialog(twoGroups(), {});
        const HairExportChoice choice = dialog.choice();
        QCOMPARE(choice.request.format, &model::exportFormats().front());
        QCOMPARE(choice.request.target, &model::exportTargets().front());
        QVERIFY(choice.source == HairSource::Now);
        QCOMPARE(choice.request.curves.groups.size(), std::size_t{2});
        QVERIFY(!choice.request.curves.hairs);
        QCOMPARE(choice.request.curves.toleranceM, 0.0F);
    }

    void keys_choose_everything()
    {
        ExportHairDialog dialog(twoGroups(), {});
        dialog.show();
        QTest::keyClick(boxAt(dialog, 0), Qt::Key_Down); // USD text
        QTest::keyClicks(boxAt(dialog, 1), QStringLiteral("Unreal"));
        QTest::keyClick(boxAt(dialog, 2), Qt::Key_End);
        BarSlider* hairs = sliderNamed(dialog, QStringLiteral("Hairs"));
        QCOMPARE(hairs->value(), 10'000.0);
        type(*hairs, QStringLiteral("2500"));
        BarSlider* tolerance = sliderNamed(dialog, QStringLiteral("Tolerance"));
        type(*tolerance, QStringLiteral("0.25"));
        const HairExportChoice choice = dialog.choice();
        QCOMPARE(choice.request.format->suffix, "usda");
        QCOMPARE(choice.request.target->id, "unreal");
        QVERIFY(choice.source == HairSource::Rest);
        QCOMPARE(choice.request.curves.hairs, std::optional<std::size_t>(2500));
        QVERIFY(std::abs(choice.request.curves.toleranceM - 0.00025F) < 1e-7F);
        // The next time it begins with them.
        const ExportHairDialog next(twoGroups(), choice);
        QCOMPARE(next.choice().request.format->suffix, "usda");
        QCOMPARE(next.choice().request.target->id, "unreal");
        QVERIFY(next.choice().source == HairSource::Rest && !next.choice().request.curves.hairs);
        QTest::keyClick(&dialog, Qt::Key_Escape);
        QVERIFY(!dialog.isVisible() && dialog.result() == QDialog::Rejected);
    }

    void the_mouse_chooses_groups_and_their_hairs()
    {
        ExportHairDialog dialog(twoGroups(), {});
        dialog.show();
        const QList<QCheckBox*> boxes = groupBoxes(dialog);
        QCOMPARE(boxes.size(), qsizetype{2});
        BarSlider* hairs = sliderNamed(dialog, QStringLiteral("Hairs"));
        boxes[0]->click();
        QCOMPARE(hairs->maximum(), 1000.0);
        QCOMPARE(dialog.choice().request.curves.groups.size(), std::size_t{1});
        QCOMPARE(dialog.choice().request.curves.groups.front().id, 5);
        QVERIFY(!dialog.choice().request.curves.hairs);
        boxes[1]->click();
        QVERIFY(!acceptButton(dialog)->isEnabled());
        const QList<QLabel*> labels = dialog.findChildren<QLabel*>();
        QVERIFY(std::ranges::any_of(
            labels, [](const QLabel* label) { return label->text().contains(QStringLiteral("no hairs")); }));
        boxes[0]->click();
        QVERIFY(acceptButton(dialog)->isEnabled());
        holdAt(*hairs, 0.5);
        letGo(*hairs);
        QVERIFY(dialog.choice().request.curves.hairs && *dialog.choice().request.curves.hairs < 9000);
        QSignalSpy exports(&dialog, &ExportHairDialog::exportWanted);
        QTest::mouseClick(acceptButton(dialog), Qt::LeftButton);
        QCOMPARE(exports.size(), 1);
        QVERIFY(dialog.isVisible()); // It is done when there is a file.
    }

    void groups_that_come_meanwhile_are_offered_and_those_left_out_stay_so()
    {
        ExportHairDialog dialog(twoGroups(), {});
        groupBoxes(dialog)[0]->click();
        BarSlider* hairs = sliderNamed(dialog, QStringLiteral("Hairs"));
        std::vector<ExportableGroup> groups = twoGroups();
        groups[1].hairs = 1500; // Painted.
        dialog.setGroups(groups);
        QCOMPARE(hairs->maximum(), 1500.0);
        groups.push_back({.id = 8, .name = QStringLiteral("Beard"), .hairs = 300});
        dialog.setGroups(groups);
        QCOMPARE(groupBoxes(dialog).size(), qsizetype{3});
        QVERIFY(!groupBoxes(dialog)[0]->isChecked());
        QCOMPARE(hairs->maximum(), 1800.0);
        QCOMPARE(dialog.choice().request.curves.groups.size(), std::size_t{2});
    }

    void a_format_with_its_own_space_asks_for_no_program()
    {
        ExportHairDialog dialog(twoGroups(), {});
        QVERIFY(boxAt(dialog, 1)->isEnabled());
        boxAt(dialog, 0)->setCurrentIndex(boxAt(dialog, 0)->count() - 1); // glTF
        QVERIFY(!boxAt(dialog, 1)->isEnabled());
    }

    void cards_ask_for_triangles_and_textures()
    {
        ExportHairDialog dialog(twoGroups(), {});
        dialog.show();
        BarSlider* triangles = sliderNamed(dialog, QStringLiteral("Triangles"));
        BarSlider* tolerance = sliderNamed(dialog, QStringLiteral("Tolerance"));
        QVERIFY(!triangles->isVisible() && !boxAt(dialog, 3)->isVisible() && tolerance->isVisible());
        boxAt(dialog, 0)->setCurrentIndex(static_cast<int>(&model::cardFormat() - model::exportFormats().data()));
        QVERIFY(triangles->isVisible() && boxAt(dialog, 3)->isVisible() && !tolerance->isVisible());
        QCOMPARE(dialog.choice().request.cards, model::CardSettings{});
        type(*triangles, QStringLiteral("8000"));
        QTest::keyClick(boxAt(dialog, 3), Qt::Key_Up);
        QTest::mouseClick(dialog.findChild<QCheckBox*>({}, Qt::FindDirectChildrenOnly), Qt::LeftButton, {},
                          QPoint(8, 8));
        const HairExportChoice choice = dialog.choice();
        QCOMPARE(choice.request.format->id, "cards");
        QCOMPARE(choice.request.cards.triangles, 8000);
        QCOMPARE(choice.request.cards.atlasPx, 1024);
        QVERIFY(choice.request.cards.springBones);
        const ExportHairDialog next(twoGroups(), choice);
        QCOMPARE(next.choice().request.cards, choice.request.cards);
    }

    void a_format_shows_the_fields_of_its_options_and_no_others()
    {
        ExportHairDialog dialog(twoGroups(), {});
        dialog.show();
        for (std::size_t i = 0; i < model::exportFormats().size(); ++i) {
            boxAt(dialog, 0)->setCurrentIndex(static_cast<int>(i));
            std::size_t fields = 0;
            for (const QWidget* widget : dialog.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
                fields += widget->isVisible() && (qobject_cast<const BarSlider*>(widget) != nullptr ||
                                                  qobject_cast<const QComboBox*>(widget) != nullptr ||
                                                  qobject_cast<const QCheckBox*>(widget) != nullptr ||
                                                  qobject_cast<const QLineEdit*>(widget) != nullptr)
                              ? 1
                              : 0;
            constexpr std::size_t kOfAll = 4; // Format, program, shape, hairs.
            const model::ExportFormat& format = model::exportFormats()[i];
            QVERIFY2(fields == kOfAll + format.options.size(), format.id);
        }
    }

    void what_is_set_is_kept_while_another_format_is_chosen()
    {
        ExportHairDialog dialog(twoGroups(), {});
        const auto cards = static_cast<int>(&model::cardFormat() - model::exportFormats().data());
        sliderNamed(dialog, QStringLiteral("Tolerance"))->setValue(2.0);
        boxAt(dialog, 0)->setCurrentIndex(cards);
        sliderNamed(dialog, QStringLiteral("Triangles"))->setValue(8000);
        QCOMPARE(dialog.choice().request.curves.toleranceM, 0.0F); // Cards follow hairs by themselves.
        boxAt(dialog, 0)->setCurrentIndex(0);
        QVERIFY(std::abs(dialog.choice().request.curves.toleranceM - 0.002F) < 1e-7F);
        QCOMPARE(dialog.choice().request.cards.triangles, 8000);
    }

    void avatars_ask_for_an_author()
    {
        ExportHairDialog dialog(twoGroups(), {});
        dialog.show();
        auto* author = dialog.findChild<QLineEdit*>({}, Qt::FindDirectChildrenOnly);
        QVERIFY(!author->isVisible());
        const std::span formats = model::exportFormats();
        const auto vrm = std::ranges::find_if(formats, &model::ExportFormat::isAvatar) - formats.begin();
        boxAt(dialog, 0)->setCurrentIndex(static_cast<int>(vrm));
        QVERIFY(author->isVisible() && sliderNamed(dialog, QStringLiteral("Triangles"))->isVisible());
        QVERIFY(!boxAt(dialog, 4)->isVisible()); // Levels of detail.
        QVERIFY(!dialog.findChild<QCheckBox*>({}, Qt::FindDirectChildrenOnly)->isVisible());
        QTest::keyClicks(author, QStringLiteral("Ann"));
        const HairExportChoice choice = dialog.choice();
        QVERIFY(choice.request.format->isAvatar);
        QCOMPARE(choice.request.author, QStringLiteral("Ann"));
        QCOMPARE(ExportHairDialog(twoGroups(), choice).choice().request.author, QStringLiteral("Ann"));
    }

    void a_head_that_makes_no_avatar_tells_why()
    {
        ExportHairDialog dialog(twoGroups(), {});
        dialog.show();
        dialog.setAvatarProblem(QStringLiteral("It has no hands."));
        const auto isTold = [&dialog] {
            const QList<QLabel*> labels = dialog.findChildren<QLabel*>();
            return std::ranges::any_of(
                labels, [](const QLabel* label) { return label->text() == QStringLiteral("It has no hands."); });
        };
        QVERIFY(acceptButton(dialog)->isEnabled() && !isTold());
        boxAt(dialog, 0)->setCurrentIndex(boxAt(dialog, 0)->count() - 1);
        QVERIFY(!acceptButton(dialog)->isEnabled() && isTold());
        dialog.setAvatarProblem({});
        QVERIFY(acceptButton(dialog)->isEnabled() && !isTold());
    }

    void one_group_needs_no_list()
    {
        const ExportHairDialog dialog({{.id = 1, .name = QStringLiteral("Scalp"), .hairs = 10}}, {});
        for (const QCheckBox* box : groupBoxes(dialog))
            QVERIFY(!box->isVisibleTo(&dialog));
        QCOMPARE(dialog.choice().request.curves.groups.size(), std::size_t{1});
    }
};

HAIRPAINT_TEST(TestExportHairDialog, Widgets)
#include "test_export_hair_dialog.moc"
