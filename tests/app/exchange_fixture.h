// The window with somebody who answers its dialogs: what comes in from other programs and goes out to them.
#pragma once

#include "app/exchange/exchange.h"
#include "model/files/glb_writing.h"
#include "tests/app/window_fixture.h"
#include "tests/support/locations.h"
#include "tests/support/test_heads.h"
#include "view/dialogs/export_hair_dialog.h"
#include "view/dialogs/export_maps_dialog.h"
#include "view/dialogs/hair_import_dialog.h"
#include "view/dialogs/head_import_dialog.h"
#include "view/dialogs/landmarks_dialog.h"
#include "view/dialogs/picture_dialog.h"

#include <QDialogButtonBox>
#include <QDropEvent>
#include <QFileDialog>
#include <QInputDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QMimeData>
#include <QPointer>
#include <QPushButton>

#include <functional>

namespace hairpaint::app {

/// Answers dialogs that wait while it lives, as a user would.
class Answerer : public QObject
{
public:
    QString file;          ///< Typed into file dialogs; they are cancelled where it is empty.
    QString name;          ///< Typed where a name is asked for.
    bool takesHead = true; ///< Whether the head's dialog is accepted.
    std::function<void(view::HeadImportDialog&)> choosesParts; ///< Before it is.
    bool takesHair = true;
    std::function<void(view::HairImportDialog&)> choosesSpace; ///< Before its dialog is accepted.
    bool takesLandmarks = true;
    std::function<void(view::LandmarksDialog&)> movesLandmarks; ///< Before its dialog is accepted.
    std::function<void(view::ExportHairDialog&)> choosesExport; ///< Before its dialog is accepted.
    std::function<void(view::ExportMapsDialog&)> choosesMaps;
    bool cancels = false; ///< Whether Cancel is clicked in progress windows.
    int cancelled = 0;    ///< How often it was.
    QStringList said;     ///< What message boxes said.

    Answerer() { startTimer(5); }

    /// Answers a dialog that stands beside the window and keeps nothing waiting; it is left where that did not end it.
    void answer(QDialog& beside)
    {
        if (auto* exported = qobject_cast<view::ExportHairDialog*>(&beside); exported != nullptr && choosesExport)
            choosesExport(*exported);
        const QPointer<QDialog> dialog(&beside); // It goes when it is done.
        press(beside, !file.isEmpty());
        if (dialog && dialog->isVisible())
            dialog->reject();
    }

protected:
    void timerEvent(QTimerEvent* /*event*/) override
    {
        QWidget* waiting = QApplication::activeModalWidget();
        if (auto* files = qobject_cast<QFileDialog*>(waiting)) {
            files->findChild<QLineEdit*>()->setText(file);
            press(*files, !file.isEmpty());
        } else if (auto* input = qobject_cast<QInputDialog*>(waiting)) {
            input->setTextValue(name);
            press(*input, true);
        } else if (auto* head = qobject_cast<view::HeadImportDialog*>(waiting)) {
            if (choosesParts)
                choosesParts(*head);
            press(*head, takesHead);
        } else if (auto* hair = qobject_cast<view::HairImportDialog*>(waiting)) {
            if (choosesSpace)
                choosesSpace(*hair);
            press(*hair, takesHair);
        } else if (auto* landmarks = qobject_cast<view::LandmarksDialog*>(waiting)) {
            if (movesLandmarks)
                movesLandmarks(*landmarks);
            press(*landmarks, takesLandmarks);
        } else if (auto* maps = qobject_cast<view::ExportMapsDialog*>(waiting)) {
            if (choosesMaps)
                choosesMaps(*maps);
            press(*maps, !file.isEmpty());
        } else if (auto* box = qobject_cast<QMessageBox*>(waiting)) {
            said += box->text();
            QAbstractButton* yes = box->button(QMessageBox::Yes);
            (yes != nullptr ? yes : box->buttons().constFirst())->click();
        } else if (waiting != nullptr && cancels && waiting->objectName() == QLatin1String("progressWindow")) {
            QTest::mouseClick(waiting->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Cancel),
                              Qt::LeftButton);
            ++cancelled;
        }
    }

private:
    static void press(QDialog& dialog, bool accept)
    {
        for (QAbstractButton* button : dialog.findChild<QDialogButtonBox*>()->buttons()) {
            const QDialogButtonBox::ButtonRole role = dialog.findChild<QDialogButtonBox*>()->buttonRole(button);
            if (role == (accept ? QDialogButtonBox::AcceptRole : QDialogButtonBox::RejectRole))
                return button->click();
        }
    }
};

/// A test derives from it and from QObject; it calls prepareDialogs() first and closeWindow() after each function.
class ExchangeFixture : protected WindowFixture
{
protected:
    std::unique_ptr<Answerer> m_answers;
    QStringList m_done; ///< What the status bar was told.

    static void prepareDialogs()
    {
        QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
        prepareApplication();
    }
    void closeWindow()
    {
        m_window.reset();
        m_answers.reset();
    }

    void open(model::Project project)
    {
        qputenv("HAIRPAINT_IMPORT",
                test::importProgram().toLocal8Bit()); // Lies beside the program, not beside this test.
        openWindow(std::move(project));
        m_answers = std::make_unique<Answerer>();
        m_done.clear();
        QObject::connect(m_window->findChild<FileWork*>(), &FileWork::done, m_answers.get(),
                         [this](const QString& text) { m_done += text; });
    }

    [[nodiscard]] QAction* action(const char* id) { return m_window->actions().find(QLatin1StringView(id)); }
    enum class Beside ///< What becomes of a dialog that the action opened beside the window.
    {
        Answer,
        Leave
    };
    void trigger(const char* id, Beside beside = Beside::Answer)
    {
        action(id)->trigger();
        for (const QPointer<QDialog>& dialog : openDialogs(*m_window))
            if (beside == Beside::Answer && dialog)
                m_answers->answer(*dialog);
    }
    [[nodiscard]] QString path(const char* name) const { return m_folder.filePath(QString::fromLatin1(name)); }

    void drop(const QString& file)
    {
        QMimeData dragged;
        dragged.setUrls({QUrl::fromLocalFile(file)});
        drop(dragged);
    }
    void drop(QMimeData& dragged)
    {
        QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &dragged, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(m_window.get(), &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent let(QPointF(300, 300), Qt::CopyAction, &dragged, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(m_window.get(), &let);
        QVERIFY(let.isAccepted());
    }

    /// Chosen in the dialog that the action opens, or dropped on the window.
    void bring(const QString& file, const char* action, bool dropped)
    {
        m_answers->file = file;
        if (dropped)
            drop(file);
        else
            trigger(action);
    }

    [[nodiscard]] const std::vector<model::Layer>& layers()
    {
        return session().document().committed().group(editor().target().group())->map(editor().target().map()).layers;
    }

    /// Left half `left`, right half white.
    [[nodiscard]] QString halfImage(const char* name, QColor left)
    {
        QImage image(64, 64, QImage::Format_RGB32);
        image.fill(Qt::white);
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 32; ++x)
                image.setPixelColor(x, y, left);
        return image.save(path(name)) ? path(name) : QString();
    }

    [[nodiscard]] QString headFile(const char* name, const sim::HeadMesh& mesh)
    {
        QFile file(path(name));
        if (!file.open(QIODevice::WriteOnly))
            return {};
        file.write(model::glbFromMesh(mesh));
        return file.fileName();
    }
    [[nodiscard]] QString ballHead(const char* name) { return headFile(name, test::makeBallHead(24, 0.11F)); }

    static void menuOrDrop()
    {
        QTest::addColumn<bool>("dropped");
        QTest::newRow("by menu") << false;
        QTest::newRow("dropped") << true;
    }
};

} // namespace hairpaint::app
