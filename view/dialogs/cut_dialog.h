// Cuts all hair of a group: trimmed, to a level, in layers, as a fade.
#pragma once

#include "model/tools/cutting/group_cut.h"
#include "view/editing/editor_state.h"

#include <QDialog>

#include <functional>
#include <memory>
#include <vector>

class QVBoxLayout;

namespace hairpaint::view {

class BarSlider;

enum class HairCut : std::uint8_t
{
    Trim,
    Level,
    Layers,
    Fade
};

/// Cuts the active group inside the selection. What is set is shown on the hair at once; accepting it is one undo step,
/// closing it none.
class CutDialog : public QDialog
{
    Q_OBJECT
public:
    /// `frame`: the hair of the document as it is, every hair positioned.
    CutDialog(EditorState& state, HairCut kind, std::shared_ptr<const sim::StrandFrame> frame,
              QWidget* parent = nullptr);
    void accept() override;
    void reject() override;

    /// False where the group has no hair to cut.
    [[nodiscard]] bool canCut() const { return m_cut.active(); }
    [[nodiscard]] static QString nothingToCutText();

private:
    void addRemark(const QString& text);
    /// In centimetres, 0 to `greatestCm`.
    BarSlider* addLength(const QString& label, double greatestCm, double startCm);
    BarSlider* addSlider(const QString& label, double least, double greatest, int decimals, double start,
                         const QString& unit);
    void addTrim();
    void addLevel();
    void addGrade(bool fades);
    void preview() { m_preview(); }

    EditorState& m_state;
    std::shared_ptr<const sim::StrandFrame> m_frame;
    model::ToolSettings m_settings;
    model::ToolContext m_context;
    model::GroupCut m_cut;
    QVBoxLayout* m_rows = nullptr;
    std::vector<BarSlider*> m_sliders;
    std::function<void()> m_preview; ///< Previews the cut that the sliders set.
};

} // namespace hairpaint::view
