// A damaged project in the window and on the command line: what can be read of it opens, and the file stays as it is.
#include "app/recovery/repair_dialog.h"
#include "tests/app/box_answer.h"
#include "tests/app/program.h"
#include "tests/app/window_fixture.h"
#include "tests/model/archive_maker.h"
#include "tests/support/test_program.h"

#include <QPlainTextEdit>

#include <algorithm>

namespace hairpaint::app {

namespace {

/// Answers the box that says what is wrong, and closes the list of what was lost.
class DamageAnswer : public BoxAnswer
{
public:
    using BoxAnswer::BoxAnswer;
    QStringList told; ///< What the list says.

protected:
    bool ends(QWidget& dialog) override
    {
        auto* list = qobject_cast<RepairDialog*>(&dialog);
        if (list == nullptr)
            return false;
        const auto* text = list->findChild<QPlainTextEdit*>();
        told += text != nullptr ? text->toPlainText() : QString();
        list->reject();
        return true;
    }
};

} // namespace

class TestRepairDamage : public QObject, private WindowFixture
{
    Q_OBJECT
private:
    QString m_path;
    QByteArray m_damaged;

    /// The file ends within the image of Direction, which comes after that of Density.
    void writeDamaged()
    {
        model::Project project = model::newProject();
        for (const model::MapKind kind : {model::MapKind::Density, model::MapKind::Direction}) {
            sim::TiledRaster& raster = project.groups.front().map(kind).layers.front().raster;
            for (int y = 0; y < raster.size(); ++y)
                for (int x = 0; x < raster.size(); x += 3)
                    raster.setTexel(x, y, {static_cast<std::uint16_t>(x * y % 60'000), 40'000, 65'535, 0});
        }
        m_path = m_folder.filePath(QStringLiteral("Maria.hairpaint"));
        QVERIFY(model::saveProject(project, m_path, {}));
        const QByteArray whole = test::readBytes(m_path);
        const std::vector<test::EntrySpan> entries = test::spansOf(whole);
        const auto cut = std::ranges::find_if(
            entries, [](const test::EntrySpan& entry) { return entry.name.contains(QStringLiteral("/direction/")); });
        QVERIFY(cut != entries.end());
        m_damaged = whole.first(cut->at + (cut->end - cut->at) / 2);
        test::writeBytes(m_path, m_damaged);
    }

private Q_SLOTS:
    void initTestCase() { prepareApplication(); }
    void init() { writeDamaged(); }
    void cleanup() { m_window.reset(); }

    void whoeverDeclinesKeepsWhatWasOpen()
    {
        openWindow(model::newProject());
        const model::Id nextId = session().document().project().nextId;
        DamageAnswer cancel(QStringLiteral("Cancel"));
        QVERIFY(!m_window->files().openPath(m_path));
        QCOMPARE(cancel.asked.size(), 1);
        QVERIFY2(cancel.asked.front().contains(QStringLiteral("Maria")), qPrintable(cancel.asked.front()));
        QCOMPARE(cancel.told, QStringList());
        QCOMPARE(session().document().project().nextId, nextId);
        QVERIFY(!session().document().modified());
    }

    void whatCanBeReadOpensAsWorkThatWasNeverSaved()
    {
        openWindow(model::newProject());
        DamageAnswer open(QStringLiteral("Open what can be read"));
        QVERIFY(m_window->files().openPath(m_path));
        QCOMPARE(open.asked.size(), 1);
        QCOMPARE(open.told.size(), 1);
        QVERIFY2(open.told.front().contains(QStringLiteral("Direction")), qPrintable(open.told.front()));
        QVERIFY2(!open.told.front().contains(QStringLiteral("Density")), qPrintable(open.told.front()));
        QVERIFY(m_window->files().path().isEmpty());
        QVERIFY2(m_window->windowTitle().contains(QStringLiteral("Maria (repaired)")),
                 qPrintable(m_window->windowTitle()));
        QVERIFY(session().document().modified());
        QVERIFY(!session().document().undoStack().canUndo());
        const model::Layer& density =
            session().document().project().groups.front().map(model::MapKind::Density).layers.front();
        QCOMPARE(density.raster.texel(300, 300), (sim::Texel{30'000, 40'000, 0, 0}));
        QCOMPARE(test::readBytes(m_path), m_damaged);
    }

    void aForeignFileIsNotOffered()
    {
        openWindow(model::newProject());
        test::writeBytes(m_path, "not a project at all");
        DamageAnswer open(QStringLiteral("Open what can be read"));
        QVERIFY(!m_window->files().openPath(m_path));
        QCOMPARE(open.asked.size(), 1);
        QCOMPARE(open.told, QStringList());
    }

    void theCommandLineRepairsToo()
    {
        const QString output = m_folder.filePath(QStringLiteral("repaired.hairpaint"));
        const test::Outcome outcome =
            test::runProgram({QStringLiteral("repair"), m_path, QStringLiteral("-o"), output});
        QCOMPARE(outcome.error, QString());
        QCOMPARE(outcome.code, 0);
        QVERIFY2(outcome.output.contains(QStringLiteral("Direction")), qPrintable(outcome.output));
        QCOMPARE(test::readBytes(m_path), m_damaged);
        QVERIFY(model::loadProject(output));
        const test::Outcome again = test::runProgram({QStringLiteral("repair"), output, QStringLiteral("-o"), output});
        QCOMPARE(again.code, 1); // It would be overwritten.
        const test::Outcome whole = test::runProgram({QStringLiteral("repair"), output, QStringLiteral("-o"),
                                                      m_folder.filePath(QStringLiteral("twice.hairpaint"))});
        QCOMPARE(whole.code, 0);
        QCOMPARE(whole.output, QStringLiteral("Nothing was lost.\n"));
        QCOMPARE(test::runProgram({QStringLiteral("repair"), m_path}).code, 2);
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestRepairDamage, Widgets)
#include "test_repair_damage.moc"
