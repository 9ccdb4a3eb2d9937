// Wherever memory runs out, files are read and written whole or not at all, and a document keeps its content.
#include "model/document/document.h"
#include "model/document/scene_commands.h"
#include "model/files/project_file.h"
#include "tests/model/archive_maker.h"
#include "tests/model/fixtures.h"
#include "tests/model/sample_project.h"
#include "tests/support/allocation_limit.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <functional>
#include <new>

using namespace hairpaint;
using namespace hairpaint::model;

namespace {

/// What came of the tries: some of each, or the limits were no test.
struct Tries
{
    int failed = 0;
    int succeeded = 0;
};

/// Works under limits from a few bytes to more than anything asks for, and judges each time without one.
template<typename T>
Tries underRisingLimits(const std::function<Result<T>()>& work, const std::function<void(const Result<T>&)>& judge)
{
    Tries tries;
    for (std::size_t limit = 16; limit < std::size_t{1} << 27U; limit += limit / 2) {
        const Result<T> result = [&] {
            const test::AllocationLimit low(limit);
            return work();
        }();
        ++(result ? tries.succeeded : tries.failed);
        judge(result);
    }
    return tries;
}

} // namespace

class TestWantOfMemory : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;
    QString m_path;

private Q_SLOTS:
    void init()
    {
        m_path = m_folder.filePath(QStringLiteral("a.hairpaint"));
        QFile::remove(m_path);
    }

    void aProjectIsOpenedOrOneSentenceSaysWhyNot()
    {
        const Project project = test::makeSampleProject();
        QVERIFY(saveProject(project, m_path, {}));
        QStringList wrong;
        const Tries tries =
            underRisingLimits<Project>([&] { return loadProject(m_path); },
                                       [&](const Result<Project>& opened) {
                                           const QString text =
                                               opened ? test::difference(project, *opened) : opened.error().message;
                                           if (opened ? !text.isEmpty() : !test::isOneSentenceNaming(text, m_path))
                                               wrong.append(text);
                                       });
        QCOMPARE(wrong, QStringList());
        QVERIFY(tries.failed > 3 && tries.succeeded > 3);
    }

    void aProjectIsSavedOrTheFileIsAsItWas()
    {
        const Project project = test::makeSampleProject();
        test::writeBytes(m_path, "old");
        const QString good = m_folder.filePath(QStringLiteral("good.hairpaint"));
        QVERIFY(saveProject(project, good, {}));
        const QByteArray whole = test::readBytes(good);
        QStringList wrong;
        const QByteArray before("old");
        const Tries tries =
            underRisingLimits<void>([&] { return saveProject(project, m_path, {}); },
                                    [&](const Result<void>& saved) {
                                        if (test::readBytes(m_path) != (saved ? whole : before))
                                            wrong.append(QStringLiteral("the bytes"));
                                        if (!saved && !test::isOneSentenceNaming(saved.error().message, m_path))
                                            wrong.append(saved.error().message);
                                        test::writeBytes(m_path, before);
                                    });
        QCOMPARE(wrong, QStringList());
        QVERIFY(tries.failed > 3 && tries.succeeded > 3);
    }

    void aDocumentIsReplacedOrKeepsItsContent()
    {
        Document document(test::filledPatch(MapKind::Length, 1234));
        document.push(setBackgroundCommand(document, 0xFF101010));
        const Project old = document.committed();
        const Id group = old.groups.front().id;
        const auto length = document.resolved(group, MapKind::Length);
        // So small that nothing fits, so that it fails at the first, at a later and at the last map in turn.
        // With the things of its patches, which a document adds.
        const Project next = Document(test::makeSampleProject()).committed();
        QStringList wrong;
        const auto check = [&wrong](bool right, const char* what) {
            if (!right)
                wrong.append(QString::fromLatin1(what));
        };
        Tries tries;
        for (std::size_t limit = 16; tries.succeeded == 0; limit += limit / 2) {
            Project another = next;
            try {
                const test::AllocationLimit low(limit);
                document.replace(std::move(another));
                ++tries.succeeded;
            } catch (const std::bad_alloc&) {
                ++tries.failed;
                check(test::sameProjects(document.committed(), old), "content");
                check(document.resolved(group, MapKind::Length) == length, "maps");
                check(document.canUndo() && document.modified(), "history");
            }
        }
        QCOMPARE(wrong, QStringList());
        QVERIFY(tries.failed > 3);
        QCOMPARE(test::difference(document.committed(), next), QString());
        QVERIFY(!document.canUndo());
        QVERIFY(document.resolved(next.groups.back().id, MapKind::Length) != nullptr);
    }
};

HAIRPAINT_TEST(TestWantOfMemory, Gui)
#include "test_want_of_memory.moc"
