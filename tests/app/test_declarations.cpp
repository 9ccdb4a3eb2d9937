// What a source defines for others is declared in the header of its name.
#include "tests/support/locations.h"
#include "tests/support/test_program.h"

#include <QDirIterator>
#include <QFile>
#include <QHash>
#include <QRegularExpression>
#include <QtTest>

#include <algorithm>

using namespace hairpaint;

namespace {

/// Headers whose functions are defined in several files: a verb, a tool, a head, a system each.
const QStringList kOfSeveralSources{QStringLiteral("app/cli/command.h"),
                                    QStringLiteral("app/cli/interruption.h"),
                                    QStringLiteral("model/disk/disk_sync.h"),
                                    QStringLiteral("model/disk/own_folder.h"),
                                    QStringLiteral("model/files/helper_confinement.h"),
                                    QStringLiteral("model/heads/built_in_heads.h"),
                                    QStringLiteral("model/tools/tool_list.h"),
                                    QStringLiteral("view/look/icon_drawing.h"),
                                    QStringLiteral("view/rendering/gl/offscreen_context.h")};

/// The contents, by path, of the four floors' files whose names end with `ending`.
QHash<QString, QString> textsOf(const QString& ending)
{
    QHash<QString, QString> texts;
    for (const char* floor : {"sim", "model", "view", "app"}) {
        QDirIterator walk(test::sourcePath(u"") + QLatin1String(floor), {QLatin1Char('*') + ending}, QDir::Files,
                          QDirIterator::Subdirectories);
        while (walk.hasNext()) {
            QFile file(walk.next());
            if (file.open(QIODevice::ReadOnly))
                texts.insert(file.fileName().mid(test::sourcePath(u"").size()), QString::fromUtf8(file.readAll()));
        }
    }
    return texts;
}

} // namespace

class TestDeclarations : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void headersDeclareWhatTheirOwnSourcesDefine()
    {
        const QRegularExpression declared(
            QStringLiteral(R"(^(?:\[\[nodiscard\]\] )?[A-Za-z][\w:<>,&* ]*[ &*\n](\w+)\((?:[^;{}]|\{\})*\);)"),
            QRegularExpression::MultilineOption);
        const QRegularExpression defined(
            QStringLiteral("^(?!static |inline |return |using |template|namespace |constexpr |struct |class )"
                           R"([A-Za-z][\w:<>,&* ]*[ &*\n](\w+)\([^;{}]*\)\n\{)"),
            QRegularExpression::MultilineOption);
        const QRegularExpression own(
            QStringLiteral("^namespace \\{$.*?^\\} // namespace$|^HWY_BEFORE_NAMESPACE.*?^HWY_AFTER_NAMESPACE"),
            QRegularExpression::MultilineOption | QRegularExpression::DotMatchesEverythingOption);
        QHash<QString, QStringList> headersOf; // By function.
        const QHash<QString, QString> headers = textsOf(QStringLiteral(".h"));
        for (auto header = headers.begin(); header != headers.end(); ++header)
            for (auto match = declared.globalMatch(*header); match.hasNext();)
                headersOf[match.next().captured(1)] += header.key();
        QVERIFY(headersOf.size() > 300);
        QHash<QString, QString> sources = textsOf(QStringLiteral(".cpp"));
        int found = 0;
        for (auto source = sources.begin(); source != sources.end(); ++source) {
            const QString ownHeader = source.key().chopped(3) + QLatin1Char('h');
            source->remove(own);
            for (auto match = defined.globalMatch(*source); match.hasNext();) {
                const QString name = match.next().captured(1);
                const QStringList where = headersOf.value(name);
                ++found;
                const bool isDeclared = where.isEmpty() || where.contains(ownHeader) ||
                                        std::ranges::any_of(where, [](const QString& header) {
                                            return kOfSeveralSources.contains(header);
                                        });
                QVERIFY2(isDeclared, qPrintable(QStringLiteral("%1 of %2 is declared in %3")
                                                    .arg(name, source.key(), where.join(QLatin1Char(' ')))));
            }
        }
        QVERIFY(found > 300);
    }
};

HAIRPAINT_TEST(TestDeclarations, None)
#include "test_declarations.moc"
