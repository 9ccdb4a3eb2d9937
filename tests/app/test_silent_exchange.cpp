// Exports to a network folder whose server does not answer, and imports from there: the window lives on, and nothing
// comes late.
#include "tests/app/exchange_fixture.h"
#include "tests/app/thin_project.h"
#include "tests/support/file_faults.h"
#include "tests/support/test_program.h"

#include <QComboBox>
#include <QTimer>

namespace hairpaint::app {

class TestSilentExchange : public QObject, private ExchangeFixture
{
    Q_OBJECT
#ifdef Q_OS_LINUX
private:
    QString m_server; ///< The folder.
    QByteArray m_pathBytes;
    QTimer m_patience;
    int m_askedByDialogs = 0; ///< Number of requests to the folder that file dialogs made on the main thread.

    [[nodiscard]] QStringList lyingThere() const
    {
        return QDir(m_server).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    }

    /// With few hairs; one window does for all.
    void openOnce()
    {
        if (m_window == nullptr) {
            open(test::thinned(starterProject()));
            hurryJobs();
        }
        m_answers->said.clear();
        m_answers->cancelled = 0;
        m_answers->choosesExport = nullptr;
        m_done.clear();
    }

private Q_SLOTS:
    void initTestCase()
    {
        prepareDialogs();
        m_server = m_folder.filePath(QStringLiteral("server"));
        m_pathBytes = QFile::encodeName(m_server);
        // Who sees that nothing answers cancels.
        connect(&m_patience, &QTimer::timeout, this, [this] {
            if (m_answers == nullptr || m_answers->cancels == (test::FileStall::waiting() > 0))
                return;
            m_answers->cancels = !m_answers->cancels;
            if (m_answers->cancels)
                m_askedByDialogs = test::FileStall::askedByMain();
        });
        m_patience.start(20);
    }
    void init()
    {
        QDir(m_server).removeRecursively();
        QVERIFY(QDir().mkpath(m_server));
    }
    void cleanupTestCase()
    {
        closeWindow();
    }

    void whatCantBeWrittenIsGivenUp_data()
    {
        QTest::addColumn<QByteArray>("action");
        QTest::addColumn<QString>("name");
        QTest::newRow("curves") << QByteArray("file.exportHair") << QStringLiteral("hair.hair");
        QTest::newRow("cards") << QByteArray("file.exportHair") << QStringLiteral("hair.glb");
        QTest::newRow("picture") << QByteArray("file.picture") << QStringLiteral("picture.png");
        QTest::newRow("linear picture") << QByteArray("file.picture") << QStringLiteral("picture.exr");
        QTest::newRow("map") << QByteArray("file.saveImage") << QStringLiteral("map.png");
        QTest::newRow("maps") << QByteArray("file.saveImages") << QString();
        QTest::newRow("UV sheet") << QByteArray("file.uvSheet") << QStringLiteral("sheet.pdf");
        QTest::newRow("add-on") << QByteArray("file.blender") << QStringLiteral("addon.py");
    }
    void whatCantBeWrittenIsGivenUp()
    {
        QFETCH(QByteArray, action);
        QFETCH(QString, name);
        openOnce();
        QTRY_VERIFY_WITH_TIMEOUT(session().hair() == Session::Hair::Current, kPatienceMs);
        m_answers->file = QDir(m_server).filePath(name);
        m_answers->choosesExport = [&name](view::ExportHairDialog& dialog) {
            if (name.endsWith(QLatin1String(".glb")))
                dialog.findChildren<QComboBox*>()[0]->setCurrentIndex(
                    static_cast<int>(&model::cardFormat() - model::exportFormats().data()));
        };
        {
            const test::FileStall stall(m_pathBytes.constData(), "fsync");
            trigger(action.constData());
            QVERIFY(m_answers->cancelled > 0);
            QCOMPARE(m_answers->said.size(), 1);
            QVERIFY2(m_answers->said.front().contains(name.isEmpty() ? QStringLiteral("server") : name),
                     qPrintable(m_answers->said.front()));
            QVERIFY2(m_answers->said.front().contains(QStringLiteral("does not answer")),
                     qPrintable(m_answers->said.front()));
            QVERIFY2(test::FileStall::askedByMain() == m_askedByDialogs, test::FileStall::lastByMain());
            QVERIFY(Jobs::anyLeft());
        }
        // It was called off, so the one who answers late writes nothing.
        QTRY_VERIFY_WITH_TIMEOUT(!Jobs::anyLeft(), kPatienceMs);
        QCOMPARE(lyingThere(), QStringList());
        QVERIFY(m_done.isEmpty());
    }

    void whatCantBeReadIsGivenUp_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"hair.hair", "style.hairpreset", "head.glb", "map.png"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }
    void whatCantBeReadIsGivenUp()
    {
        QFETCH(QString, name);
        openOnce();
        const QString file = QDir(m_server).filePath(name);
        {
            QFile there(file);
            QVERIFY(there.open(QIODevice::WriteOnly) && there.write("something") > 0);
        }
        const std::vector<model::HairGroup> before = session().document().committed().groups;
        {
            const test::FileStall stall(m_pathBytes.constData());
            m_window->openFile(file);
            QVERIFY(m_answers->cancelled > 0);
            QCOMPARE(m_answers->said.size(), 1);
            QVERIFY2(m_answers->said.front().contains(name), qPrintable(m_answers->said.front()));
            QVERIFY2(m_answers->said.front().contains(QStringLiteral("does not answer")),
                     qPrintable(m_answers->said.front()));
            QVERIFY2(test::FileStall::askedByMain() == 0, test::FileStall::lastByMain());
        }
        QTRY_VERIFY_WITH_TIMEOUT(!Jobs::anyLeft(), kPatienceMs);
        QVERIFY(session().document().committed().groups == before);
    }
#endif
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestSilentExchange, Widgets)
#include "test_silent_exchange.moc"
