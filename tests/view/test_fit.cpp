// Nothing is cut off at the smallest sizes, in both themes and with long words; icons and themes are whole.
#include "model/tools/tool_list.h"
#include "panel_fixture.h"

#include "tests/support/await.h"
#include "tests/support/clipping.h"
#include "tests/support/import_sample.h"
#include "tests/support/pseudo_languages.h"
#include "tests/support/test_heads.h"
#include "tests/support/test_program.h"
#include "view/dialogs/about_dialog.h"
#include "view/dialogs/hair_import_dialog.h"
#include "view/dialogs/head_import_dialog.h"
#include "view/dialogs/light_dialog.h"
#include "view/dialogs/picture_dialog.h"
#include "view/dialogs/preferences_dialog.h"
#include "view/dialogs/wind_dialog.h"
#include "view/look/icons.h"
#include "view/look/theme.h"
#include "view/panels/option_bar.h"
#include "view/panels/sidebar.h"
#include "view/panels/status_readout.h"
#include "view/panels/style_strip.h"
#include "view/panels/tool_bar.h"
#include "view/widgets/colour_math.h"
#include "view/widgets/value_palette.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QFile>
#include <QRegularExpression>

#include <functional>
#include <map>

using namespace hairpaint;
using namespace hairpaint::view;

namespace {

using Make = std::function<std::unique_ptr<QWidget>(EditorState&)>;

/// Every panel and dialog, with the least size that it must work at.
std::map<QString, std::pair<Make, QSize>> everything()
{
    const auto of = []<typename T>(std::type_identity<T>) -> Make {
        return [](EditorState& state) { return std::make_unique<T>(state); };
    };
    return {
        {QStringLiteral("tool bar"), {of(std::type_identity<ToolBar>{}), {44, 460}}},
        {QStringLiteral("option bar"), {of(std::type_identity<OptionBar>{}), {1100, 40}}},
        {QStringLiteral("sidebar"), {of(std::type_identity<Sidebar>{}), {280, 460}}},
        {QStringLiteral("hair"),
         {[](EditorState& state) {
              auto sidebar = std::make_unique<Sidebar>(state);
              sidebar->showHair();
              return sidebar;
          },
          {280, 460}}},
        {QStringLiteral("status"), {of(std::type_identity<StatusReadout>{}), {1100, 24}}},
        {QStringLiteral("palette"), {of(std::type_identity<ValuePalette>{}), {}}},
        {QStringLiteral("wind"), {of(std::type_identity<WindDialog>{}), {}}},
        {QStringLiteral("light"), {of(std::type_identity<LightDialog>{}), {}}},
        {QStringLiteral("about"),
         {[](EditorState&) {
              return std::make_unique<AboutDialog>(QStringLiteral("0.1.0"), QStringList{QStringLiteral("Qt 6.4.2")},
                                                   QStringLiteral("llvmpipe"));
          },
          {}}},
        {QStringLiteral("import"),
         {[](EditorState&) {
              return std::make_unique<HeadImportDialog>(test::makeBallHead(), QStringLiteral("head.obj"));
          },
          {}}},
        {QStringLiteral("hair import"),
         {[](EditorState&) {
              return std::make_unique<HairImportDialog>(test::importSample(), QStringLiteral("long.hair"));
          },
          {}}},
        {QStringLiteral("picture"),
         {[](EditorState&) { return std::make_unique<PictureDialog>(PictureChoice{}, QSize(600, 800)); }, {}}},
        {QStringLiteral("preferences"),
         {[](EditorState&) {
              return std::make_unique<PreferencesDialog>(Preferences{}, std::vector<std::pair<QString, QString>>{},
                                                         std::vector<KeyBinding>{});
          },
          {}}},
    };
}

} // namespace

class TestFit : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nothing_is_cut_off_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("light");
        QTest::addColumn<bool>("longWords");
        for (const auto& [name, entry] : everything())
            for (const bool light : {false, true})
                for (const bool longWords : {false, true})
                    QTest::addRow("%s, %s, %s", qPrintable(name), light ? "light" : "dark",
                                  longWords ? "long words" : "English")
                        << name << light << longWords;
    }
    void nothing_is_cut_off()
    {
        QFETCH(QString, name);
        QFETCH(bool, light);
        QFETCH(bool, longWords);
        applyTheme(*qApp, light ? ThemeKind::Light : ThemeKind::Dark);
        test::LongWords words;
        if (longWords)
            QCoreApplication::installTranslator(&words);
        PanelFixture f;
        const auto [make, size] = everything()[name];
        for (const model::MapSpec& spec : model::mapSpecs()) {
            f.state.target().setMap(spec.kind);
            const auto widget = make(f.state);
            if (size.isValid()) {
                widget->resize(size);
                QVERIFY2(widget->minimumSizeHint().width() <= size.width() &&
                             widget->minimumSizeHint().height() <= size.height(),
                         qPrintable(QStringLiteral("needs %1 x %2")
                                        .arg(widget->minimumSizeHint().width())
                                        .arg(widget->minimumSizeHint().height())));
            } else {
                widget->adjustSize();
            }
            widget->show();
            QVERIFY(QTest::qWaitForWindowExposed(widget.get()));
            const QStringList cut = test::clipped(*widget);
            QVERIFY2(cut.isEmpty(),
                     qPrintable(QLatin1String(spec.id) + QStringLiteral(": ") + cut.join(QStringLiteral("; "))));
        }
        QCoreApplication::removeTranslator(&words);
    }

    void every_tool_shows_its_options_whole()
    {
        applyTheme(*qApp, ThemeKind::Dark);
        PanelFixture f;
        OptionBar bar(f.state);
        bar.resize(1100, 40);
        bar.show();
        for (const auto& tool : f.state.tools().all()) {
            f.state.tools().choose(tool->id());
            test::handleDueEvents();
            const QStringList cut = test::clipped(bar);
            QVERIFY2(cut.isEmpty(), qPrintable(cut.join(QStringLiteral("; "))));
        }
    }

    void a_box_opens_to_all_its_rows()
    {
        applyTheme(*qApp, ThemeKind::Dark);
        PanelFixture f;
        Sidebar sidebar(f.state);
        sidebar.resize(280, 600);
        sidebar.show();
        auto* box = sidebar.layers().findChild<QComboBox*>();
        QVERIFY(box->count() > 1);
        box->showPopup();
        const QRect seen = box->view()->viewport()->rect();
        for (int row = 0; row < box->count(); ++row) {
            const QRect bounds = box->view()->visualRect(box->model()->index(row, 0));
            QVERIFY(bounds.height() > 20);
            QVERIFY2(seen.contains(bounds), qPrintable(box->itemText(row)));
        }
        box->hidePopup();
    }

    void every_tool_and_map_has_an_icon()
    {
        for (const auto& tool : model::makeTools())
            QVERIFY2(hasIcon(QLatin1String(tool->name())), tool->name());
        for (const model::MapSpec& spec : model::mapSpecs())
            QVERIFY2(hasIcon(QLatin1String(spec.id)), spec.id);
        QVERIFY(!hasIcon(QStringLiteral("no such icon")));
    }

    void icons_are_drawn_in_one_colour_at_every_size()
    {
        QVERIFY(iconNames().size() > 50);
        for (const QString& name : iconNames()) {
            for (const qreal ratio : {1.0, 1.25, 2.0}) {
                const QImage image =
                    iconPixmap(name, 20, QColor(200, 40, 90), ratio).toImage().convertToFormat(QImage::Format_ARGB32);
                QCOMPARE(image.width(), qRound(20 * ratio));
                int drawn = 0;
                for (int y = 0; y < image.height(); ++y) {
                    for (int x = 0; x < image.width(); ++x) {
                        const QRgb pixel = image.pixel(x, y);
                        if (qAlpha(pixel) < 200)
                            continue;
                        ++drawn;
                        QVERIFY2(std::abs(qRed(pixel) - 200) < 6 && std::abs(qGreen(pixel) - 40) < 6 &&
                                     std::abs(qBlue(pixel) - 90) < 6,
                                 qPrintable(name));
                    }
                }
                QVERIFY2(drawn > 0, qPrintable(name));
            }
        }
    }

    void icons_stay_inside_their_grid()
    {
        for (const QString& name : iconNames()) {
            const QImage image = iconPixmap(name, 96, Qt::black, 1.0).toImage();
            for (int i = 0; i < 96; ++i)
                for (const QPoint edge : {QPoint(i, 0), QPoint(i, 95), QPoint(0, i), QPoint(95, i)})
                    QVERIFY2(qAlpha(image.pixel(edge)) == 0, qPrintable(name));
        }
    }

    void the_style_sheet_names_no_unknown_colour_and_no_missing_picture()
    {
        for (const ThemeKind kind : {ThemeKind::Dark, ThemeKind::Light}) {
            applyTheme(*qApp, kind);
            const QString sheet = Theme::of(kind).styleSheet();
            QVERIFY(sheet.size() > 1000);
            QString rules = sheet;
            rules.remove(
                QRegularExpression(QStringLiteral("/\\*.*?\\*/"), QRegularExpression::DotMatchesEverythingOption));
            QVERIFY2(!rules.contains(QLatin1Char('@')), qPrintable(rules.mid(rules.indexOf(QLatin1Char('@')), 40)));
            static const QRegularExpression url(QStringLiteral("url\\(([^)]*)\\)"));
            for (auto match = url.globalMatch(sheet); match.hasNext();) {
                const QString path = match.next().captured(1);
                QVERIFY2(QFile::exists(path), qPrintable(path));
            }
        }
    }

    void text_is_readable_in_both_themes()
    {
        for (const ThemeKind kind : {ThemeKind::Dark, ThemeKind::Light}) {
            const Theme theme = Theme::of(kind);
            for (const QColor& ground : {theme.window, theme.panel, theme.raised}) {
                QVERIFY(contrast(theme.text, ground) >= 7.0);
                QVERIFY(contrast(theme.dimText, ground) >= 4.5);
                QVERIFY(contrast(theme.text, mixed(ground, theme.accent, 0.30)) >= 4.5);
                QVERIFY(contrast(theme.accent, ground) >= 3.0);
            }
            QVERIFY(contrast(theme.onAccent, theme.accent) >= 4.5);
        }
    }

    void panels_follow_a_change_of_theme_while_they_are_open()
    {
        PanelFixture f;
        applyTheme(*qApp, ThemeKind::Dark);
        Sidebar sidebar(f.state);
        sidebar.resize(280, 600);
        sidebar.show();
        const QRgb dark = sidebar.grab().toImage().pixel(4, 4);
        applyTheme(*qApp, ThemeKind::Light);
        test::handleDueEvents();
        const QRgb light = sidebar.grab().toImage().pixel(4, 4);
        QCOMPARE(QColor(dark), Theme::of(ThemeKind::Dark).panel);
        QCOMPARE(QColor(light), Theme::of(ThemeKind::Light).panel);
    }
};

HAIRPAINT_TEST(TestFit, Widgets)
#include "test_fit.moc"
