// The line at the window's foot: the value under the pointer, errors, and limits on hairs.
#include "panel_fixture.h"

#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "view/panels/status_readout.h"

#include <QLabel>

#include <algorithm>

using namespace hairpaint;
using namespace hairpaint::view;

class TestStatusReadout : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void the_status_line_shows_the_value_under_the_pointer_and_errors()
    {
        PanelFixture f;
        StatusReadout status(f.state);
        status.resize(1100, 24);
        status.show();
        const auto texts = [&] {
            QString all;
            for (const QLabel* label : status.findChildren<QLabel*>())
                all += label->text() + QLatin1Char('|');
            return all;
        };
        sim::SurfacePoint point;
        point.uv = {0.5F, 0.5F};
        f.state.hover().set(HoverPoint{.uv = point.uv, .point = point});
        QVERIFY2(texts().contains(QStringLiteral("Length: 15")), qPrintable(texts()));
        f.state.hover().set(std::nullopt);
        QVERIFY(!texts().contains(QStringLiteral("Length: 15")));
        status.showMessage(QStringLiteral("It is locked."), true, 50);
        QVERIFY(texts().contains(QStringLiteral("It is locked.")));
        QTRY_VERIFY_WITH_TIMEOUT(texts().contains(f.state.tools().active().hint()), test::kPatienceMs);
    }

    void every_kind_of_comb_says_what_it_does()
    {
        PanelFixture f;
        StatusReadout status(f.state);
        f.state.tools().choose(model::ToolId::Comb);
        QSet<QString> said;
        for (const auto kind : {model::CombKind::Lay, model::CombKind::Lift, model::CombKind::Smooth,
                                model::CombKind::Noise, model::CombKind::Whorl, model::CombKind::Hold}) {
            model::ToolSettings settings = f.state.tools().settings();
            settings.comb = kind;
            f.state.tools().setSettings(settings);
            const QString hint = f.state.tools().active().hintFor(settings);
            said.insert(hint);
            bool shown = false;
            for (const QLabel* label : status.findChildren<QLabel*>())
                shown = shown || label->text() == hint;
            QVERIFY2(shown, qPrintable(hint));
        }
        QCOMPARE(said.size(), 6);
    }

    void the_status_line_tells_what_is_saved_and_paused_and_what_erasing_reveals()
    {
        PanelFixture f;
        StatusReadout status(f.state);
        const auto says = [&](const QString& words) {
            return std::ranges::any_of(status.findChildren<QLabel*>(),
                                       [&](const QLabel* label) { return label->text().contains(words); });
        };
        QVERIFY(status.savedText().isEmpty());
        status.setSaved(StatusReadout::Saved::No);
        QVERIFY(says(QStringLiteral("Not saved")));
        status.setSaved(StatusReadout::Saved::Yes);
        QVERIFY(status.savedText().contains(QStringLiteral("Saved")));
        status.setSimulationMs(2.0);
        status.setPaused(true);
        status.setSimulationMs(3.0);
        QVERIFY(says(QStringLiteral("Paused")) && !says(QStringLiteral("3.0")));
        status.setPaused(false);
        status.setSimulationMs(3.0);
        QVERIFY(says(QStringLiteral("3.0")));
        f.state.tools().choose(model::ToolId::Eraser);
        QVERIFY(says(QStringLiteral("reveals 15")));
        Q_EMIT f.document.refused(QStringLiteral("It would be too much."));
        QVERIFY(says(QStringLiteral("too much")));
    }

    void the_status_line_tells_that_a_limit_on_hairs_bites_and_why()
    {
        PanelFixture f;
        StatusReadout status(f.state);
        const auto shown = [&](qint64 drawn, qint64 all, sim::HairLimit limit) {
            status.setHairs(drawn, all, limit);
            for (const QLabel* label : status.findChildren<QLabel*>())
                if (label->text().contains(QStringLiteral("hairs")) && label->text().front().isDigit())
                    return std::pair(label->text(), label->toolTip());
            return std::pair(QString(), QString());
        };
        const auto says = [&status](const QString& words) {
            const QList<QLabel*> labels = status.findChildren<QLabel*>();
            return std::ranges::any_of(labels, [&](const QLabel* label) { return label->text().contains(words); });
        };
        const auto free = shown(50, 50, sim::HairLimit::None);
        const auto limited = shown(50, 50, sim::HairLimit::MaxHairs);
        QVERIFY(says(QStringLiteral("A lower greatest density")));
        status.showMessage(QStringLiteral("another"));
        (void)shown(50, 50, sim::HairLimit::MaxHairs); // It is said once.
        QVERIFY(says(QStringLiteral("another")));
        const auto heavy = shown(40, 50, sim::HairLimit::Memory);
        QCOMPARE(free, std::pair(QStringLiteral("50 hairs"), QString()));
        QCOMPARE(limited.first, QStringLiteral("50 hairs, limit reached"));
        QVERIFY2(limited.second.contains(QStringLiteral("project's limit")), qPrintable(limited.second));
        QCOMPARE(heavy.first, QStringLiteral("40 of 50 hairs, limit reached"));
        QVERIFY2(heavy.second.contains(QStringLiteral("memory")), qPrintable(heavy.second));
        QCOMPARE(shown(50, 50, sim::HairLimit::None), free);
    }
};

HAIRPAINT_TEST(TestStatusReadout, Widgets)
#include "test_status_readout.moc"
