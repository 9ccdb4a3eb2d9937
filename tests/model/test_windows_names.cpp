// Names that Windows would write to something else, or not at all, are told on every system.
#include "model/disk/windows_names.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace hairpaint::model;

class TestWindowsNames : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aNameThatCanBeNoFilesIsRefused_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("because");
        const QString device = QStringLiteral("device");
        for (const char* name : {"NUL", "nul", "CON", "con.hairpaint", "Aux.tar.xz", "PRN", "COM1", "com9.png",
                                 "LPT3.txt", "CONIN$", "conout$", "NUL .png"})
            QTest::newRow(name) << QString::fromLatin1(name) << device;
        QTest::newRow("a superscript digit's port") << QStringLiteral("COM\u00B2") << device;
        for (const char* name : {"a<b", "a>b", "a:b", "a\"b", "a|b", "a?b", "a*b", "a\tb"})
            QTest::newRow(name) << QString::fromLatin1(name) << QStringLiteral("one of");
        for (const char* name : {"hair.", "hair ", "hair.png..", "hair.png "})
            QTest::newRow(name) << QString::fromLatin1(name) << QStringLiteral("ends with");
    }
    void aNameThatCanBeNoFilesIsRefused()
    {
        QFETCH(const QString, name);
        QFETCH(const QString, because);
        const QString problem = windowsNameProblem(name);
        QVERIFY2(problem.contains(because), qPrintable(problem));
    }

    void otherNamesAreTaken_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"hair.png", "null.png", "contour", "console.hairpaint", "COM10", "COM0", "COMX", "LPT",
                                 ".hidden", "a b.c", "auxiliary"})
            QTest::newRow(name) << QString::fromLatin1(name);
        QTest::newRow("letters of other scripts") << QStringLiteral("\u9AEA.png");
    }
    void otherNamesAreTaken()
    {
        QFETCH(const QString, name);
        QCOMPARE(windowsNameProblem(name), QString());
    }

    void aLongPathIsToldVerbatim_data()
    {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("told");
        const QString deep = QString(300, QLatin1Char('x'));
        QTest::newRow("short") << QStringLiteral("C:\\hair.png") << QStringLiteral("C:\\hair.png");
        QTest::newRow("long") << QStringLiteral("C:\\") + deep << QStringLiteral("\\\\?\\C:\\") + deep;
        QTest::newRow("long, of a server")
            << QStringLiteral("\\\\server\\share\\") + deep << QStringLiteral("\\\\?\\UNC\\server\\share\\") + deep;
        QTest::newRow("verbatim already")
            << QStringLiteral("\\\\?\\C:\\") + deep << QStringLiteral("\\\\?\\C:\\") + deep;
    }
    void aLongPathIsToldVerbatim()
    {
        QFETCH(const QString, path);
        QFETCH(const QString, told);
        QCOMPARE(windowsPath(path), told);
    }
};

HAIRPAINT_TEST(TestWindowsNames, None)
#include "test_windows_names.moc"
