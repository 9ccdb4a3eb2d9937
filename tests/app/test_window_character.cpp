// A character of several parts in the window, by mouse: what comes in, what hair grows on, what is drawn beside it.
#include "model/files/glb_writing.h"
#include "tests/app/exchange_fixture.h"
#include "tests/support/character.h"
#include "tests/support/test_program.h"

#include <QTableWidget>

using namespace hairpaint;
using namespace hairpaint::app;

class TestWindowCharacter : public QObject, private ExchangeFixture
{
    Q_OBJECT
private:
    [[nodiscard]] QString character() const
    {
        const QString path = m_folder.filePath(QStringLiteral("Ann.glb"));
        QFile file(path);
        [[maybe_unused]] const bool opened = file.open(QIODevice::WriteOnly);
        file.write(model::glbFromMesh(test::makeCharacter()));
        return path;
    }
    static void click(QTableWidget& parts, const char* name, int column)
    {
        for (int row = 0; row < parts.rowCount(); ++row) {
            if (parts.item(row, 0)->text() != QString::fromLatin1(name))
                continue;
            const QRect cell = parts.visualItemRect(parts.item(row, column));
            QTest::mouseClick(parts.viewport(), Qt::LeftButton, {}, QPoint(cell.left() + 10, cell.center().y()));
            return;
        }
        QFAIL("there is no such part");
    }

private Q_SLOTS:
    void initTestCase() { prepareDialogs(); }
    void cleanup() { closeWindow(); }

    void aCharacterComesInWithHairOnItsScalpAndItsPartsInSight()
    {
        open(test::thinned(starterProject()));
        m_answers->file = character();
        int unasked = 0;
        m_answers->choosesParts = [&unasked](view::HeadImportDialog& dialog) {
            auto* const parts = dialog.findChild<QTableWidget*>();
            QVERIFY(parts != nullptr);
            for (int row = 0; row < parts->rowCount(); ++row)
                unasked += parts->item(row, 2)->checkState() == Qt::Checked ? 1 : 0;
            click(*parts, "Bag", 1);
        };
        trigger("file.importHead");
        QCOMPARE(unasked, 1);
        const std::shared_ptr<const model::Head> head = session().document().committed().head;
        QVERIFY(head && !head->builtIn);
        QCOMPARE(head->parts.size(), std::size_t{4}); // The bag stays out.
        for (const glm::vec3& position : head->skin->mesh().positionsHd)
            QVERIFY(glm::distance(position, test::kCharacterHead) < 0.13F);
        awaitNewestHair();
        QVERIFY(hairs() > 100);
    }

    void aDialogWithoutAPartThatGrowsHairImportsNothing()
    {
        open(model::newProject());
        m_answers->file = character();
        m_answers->takesHead = false;
        bool isOffered = true;
        bool isOfferedAgain = false;
        m_answers->choosesParts = [&](view::HeadImportDialog& dialog) {
            auto* const parts = dialog.findChild<QTableWidget*>();
            const QPushButton* const take = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
            click(*parts, "Head", 2);
            isOffered = take->isEnabled();
            click(*parts, "Bag", 2);
            isOfferedAgain = take->isEnabled();
        };
        trigger("file.importHead");
        QVERIFY(!isOffered);
        QVERIFY(isOfferedAgain);
    }
};

HAIRPAINT_TEST(TestWindowCharacter, Widgets)
#include "test_window_character.moc"
