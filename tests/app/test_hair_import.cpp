// Hair of other programs, by the window's menu, dropped on it, and from the command line.
#include "model/exporting/hair_file.h"
#include "model/files/project_file.h"
#include "model/importing/curve_reader.h"
#include "tests/app/exchange_fixture.h"
#include "tests/app/program.h"
#include "tests/app/thin_project.h"
#include "tests/support/test_program.h"

#include <QComboBox>
#include <QJsonArray>
#include <QtTest>

#include <cmath>

namespace hairpaint::app {

namespace {

const QString kNew = QStringLiteral("new");
const QString kExport = QStringLiteral("export");
const QString kOutput = QStringLiteral("-o");

} // namespace

class TestHairImport : public QObject, private ExchangeFixture
{
    Q_OBJECT
private:
    QTemporaryDir m_files;
    QString m_original; ///< A project of a style.

    [[nodiscard]] QString file(const QString& name) const { return m_files.filePath(name); }

    /// Exports the original and makes a project of what that gives; empty, or what went wrong.
    [[nodiscard]] QString roundTrip(const QString& exported, const QString& back) const
    {
        // Text is written as .usda, and read as .usd, too.
        const QString written = exported.endsWith(QLatin1String(".usd")) ? exported + QLatin1Char('a') : exported;
        const test::Outcome out = test::runProgram({kExport, m_original, kOutput, written});
        if (out.code != 0)
            return out.error;
        if (written != exported && !QFile::rename(written, exported))
            return written;
        const test::Outcome in = test::runProgram({kNew, kOutput, back, QStringLiteral("--curves"), exported});
        return in.code == 0 ? in.error : in.error + QStringLiteral(" failed");
    }

private Q_SLOTS:
    void initTestCase()
    {
        prepareDialogs();
        m_original = file(QStringLiteral("original.hairpaint"));
        const test::Outcome made =
            test::runProgram({kNew, kOutput, m_original, QStringLiteral("--preset"), QStringLiteral("French crop")});
        QVERIFY2(made.code == 0, qPrintable(made.error));
        QVERIFY(test::thinOut(m_original));
    }
    void cleanup() { closeWindow(); }

    void exportedHairComesBack_data()
    {
        QTest::addColumn<QString>("ending");
        for (const QString& ending : model::curveFileEndings())
            QTest::newRow(qPrintable(ending)) << ending;
    }
    void exportedHairComesBack()
    {
        QFETCH(QString, ending);
        const QString back = file(QStringLiteral("back.hairpaint"));
        QCOMPARE(roundTrip(file(QStringLiteral("out.") + ending), back), QString());
        const auto before = test::infoOf(m_original).value(QLatin1String("exported")).toDouble();
        const QJsonObject info = test::infoOf(back);
        const auto after = info.value(QLatin1String("exported")).toDouble();
        QVERIFY2(std::abs(after / before - 1.0) < 0.03, qPrintable(QString::number(after / before)));
        const QJsonArray groups = info.value(QLatin1String("groups")).toArray();
        QCOMPARE(groups.size(), qsizetype{1});
        QCOMPARE(groups[0].toObject().value(QLatin1String("name")).toString(),
                 ending == QLatin1String("hair") ? QStringLiteral("out") : QStringLiteral("Scalp"));
    }

    void theHairThatComesBackHasItsLengthAndDirection()
    {
        const QString first = file(QStringLiteral("first.hair"));
        const QString back = file(QStringLiteral("back.hairpaint"));
        const QString second = file(QStringLiteral("second.hair"));
        QCOMPARE(roundTrip(first, back), QString());
        QCOMPARE(test::runProgram({kExport, back, kOutput, second}).code, 0);
        const model::Result<model::ForeignCurves> a = model::readCurves(first);
        const model::Result<model::ForeignCurves> b = model::readCurves(second);
        QVERIFY(a && b);
        const model::ForeignStrands& before = a->groups.front();
        const model::ForeignStrands& after = b->groups.front();
        double lengthBefore = 0.0;
        double lengthAfter = 0.0;
        for (std::size_t i = 0; i < before.count(); ++i)
            lengthBefore +=
                glm::distance(before.strand(i).front(), before.strand(i).back()) / static_cast<double>(before.count());
        for (std::size_t i = 0; i < after.count(); ++i)
            lengthAfter +=
                glm::distance(after.strand(i).front(), after.strand(i).back()) / static_cast<double>(after.count());
        QVERIFY2(std::abs(lengthAfter / lengthBefore - 1.0) < 0.05,
                 qPrintable(QString::number(lengthAfter / lengthBefore)));
        // For every twentieth hair, the imported hair with the nearest root goes about as far in about the same
        // direction.
        double apart = 0.0;
        double gone = 0.0;
        for (std::size_t i = 0; i < before.count(); i += 20) {
            const auto hair = before.strand(i);
            std::size_t nearest = 0;
            for (std::size_t j = 1; j < after.count(); ++j)
                if (glm::distance(after.strand(j).front(), hair.front()) <
                    glm::distance(after.strand(nearest).front(), hair.front()))
                    nearest = j;
            const glm::vec3 offset = hair.back() - hair.front();
            const glm::vec3 offsetAfter = after.strand(nearest).back() - after.strand(nearest).front();
            apart += glm::distance(offset, offsetAfter);
            gone += glm::length(offset);
        }
        QVERIFY2(apart < 0.25 * gone, qPrintable(QString::number(apart / gone)));
    }

    void importedHairIsANewGroup_data() { menuOrDrop(); }
    void importedHairIsANewGroup()
    {
        QFETCH(bool, dropped);
        const QString curves = file(QStringLiteral("crop.hair"));
        QCOMPARE(test::runProgram({kExport, m_original, kOutput, curves}).code, 0);
        open(model::newProject());
        model::Document& document = session().document();
        bring(curves, "file.importHair", dropped);
        QTRY_COMPARE_WITH_TIMEOUT(stack().count(), 1, kPatienceMs);
        QCOMPARE(stack().undoText(), QStringLiteral("Import crop.hair"));
        QCOMPARE(document.committed().groups.size(), std::size_t{2});
        QCOMPARE(document.committed().groups.back().name, QStringLiteral("crop"));
        QCOMPARE(editor().target().group(), document.committed().groups.back().id);
        document.undo();
        QCOMPARE(document.committed().groups.size(), std::size_t{1});
    }

    void theDialogsUnitAndAxisAreTakenAndCancelImportsNothing()
    {
        const QString curves = file(QStringLiteral("turned.hair"));
        QCOMPARE(test::runProgram(
                     {kExport, m_original, kOutput, curves, QStringLiteral("--target"), QStringLiteral("blender")})
                     .code,
                 0);
        open(model::newProject());
        m_answers->takesHair = false;
        int asked = 0;
        m_answers->choosesSpace = [&asked](view::HairImportDialog& dialog) {
            const model::CurveSpaceChoice choice = dialog.choice();
            QVERIFY(!choice.metresPerUnit && !choice.upAxis);
            ++asked;
        };
        drop(curves);
        QTRY_COMPARE_WITH_TIMEOUT(asked, 1, kPatienceMs);
        test::handleDueEvents();
        QCOMPARE(stack().count(), 0);

        m_answers->takesHair = true;
        m_answers->choosesSpace = [&asked](view::HairImportDialog& dialog) {
            for (auto* box : dialog.findChildren<QComboBox*>())
                for (int i = 0; i < box->count(); ++i)
                    if (box->itemText(i) == QLatin1String("Metres") || box->itemText(i).startsWith(QLatin1Char('Z')))
                        box->setCurrentIndex(i);
            const model::CurveSpaceChoice choice = dialog.choice();
            QVERIFY(choice.metresPerUnit == 1.0F && choice.upAxis == model::UpAxis::Z);
            ++asked;
        };
        drop(curves);
        QTRY_COMPARE_WITH_TIMEOUT(stack().count(), 1, kPatienceMs);
        QCOMPARE(asked, 2);
        QCOMPARE(session().document().committed().groups.back().name, QStringLiteral("turned"));
    }

    void whatIsNoHairIsSaidAndChangesNothing()
    {
        const QString broken = file(QStringLiteral("broken.hair"));
        QFile written(broken);
        QVERIFY(written.open(QIODevice::WriteOnly) && written.write("HAIR and no more") > 0);
        written.close();
        open(model::newProject());
        drop(broken);
        QTRY_COMPARE_WITH_TIMEOUT(m_answers->said.size(), 1, kPatienceMs);
        QVERIFY2(m_answers->said.front().contains(QStringLiteral("broken.hair")), qPrintable(m_answers->said.front()));
        QCOMPARE(stack().count(), 0);

        const QString project = file(QStringLiteral("none.hairpaint"));
        const test::Outcome outcome = test::runProgram({kNew, kOutput, project, QStringLiteral("--curves"), broken});
        QCOMPARE(outcome.code, 1);
        QCOMPARE(outcome.error.count(QLatin1Char('\n')), 1);
        QVERIFY2(outcome.error.contains(QStringLiteral("broken.hair")), qPrintable(outcome.error));
        QVERIFY(!QFile::exists(project));
    }

    void unitAndAxisAreTakenAsGiven()
    {
        const QString curves = file(QStringLiteral("maya.hair"));
        QCOMPARE(test::runProgram(
                     {kExport, m_original, kOutput, curves, QStringLiteral("--target"), QStringLiteral("unreal")})
                     .code,
                 0);
        const auto made = [&](const char* unit, const char* axis) {
            return test::runProgram({kNew, kOutput, file(QStringLiteral("unit.hairpaint")), QStringLiteral("--curves"),
                                     curves, QStringLiteral("--curves-unit"), QString::fromLatin1(unit),
                                     QStringLiteral("--curves-axis"), QString::fromLatin1(axis)})
                .code;
        };
        QCOMPARE(made("cm", "z"), 0);
        QCOMPARE(made("feet", "z"), 2);
        QCOMPARE(made("cm", "up"), 2);
    }
};

} // namespace hairpaint::app

using hairpaint::app::TestHairImport;
HAIRPAINT_TEST(TestHairImport, Widgets)
#include "test_hair_import.moc"
