// A kind of option, a kind of widget.
#include "view/dialogs/export_option_fields.h"

#include "view/widgets/bar_slider.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QFormLayout>
#include <QLineEdit>

#include <algorithm>
#include <cmath>

namespace hairpaint::view {

namespace {

using model::ExportRequest;

/// A list of whole numbers.
template<class Values>
QComboBox* numberList(const Values& values, const QString& text, QWidget& dialog)
{
    auto* box = new QComboBox(&dialog);
    for (const int value : values)
        box->addItem(text.arg(value), value);
    return box;
}

BarSlider* numberSlider(const model::ExportOption& option, const model::ExportNumber& number, QWidget& dialog)
{
    auto* slider = new BarSlider(option.labelText(), &dialog);
    slider->setRange(number.least, number.greatest, number.decimals);
    slider->setExponent(number.exponent);
    slider->setDefaultValue(number.read({}));
    if (*number.unit != '\0')
        slider->setUnit(QCoreApplication::translate("Export", number.unit));
    slider->setHint(option.hintText());
    return slider;
}

} // namespace

ExportOptionFields::ExportOptionFields(QFormLayout& form, QWidget& dialog) : m_form(form)
{
    for (const model::ExportOption* option : model::exportOptionRows())
        m_fields.push_back(fieldOf(*option, form, dialog));
}

ExportOptionFields::Field ExportOptionFields::fieldOf(const model::ExportOption& option, QFormLayout& form,
                                                      QWidget& dialog)
{
    Field field{.option = &option, .widget = nullptr, .fill = {}, .put = {}};
    if (const auto* number = std::get_if<model::ExportNumber>(&option.kind); number != nullptr && !number->isList) {
        BarSlider* slider = numberSlider(option, *number, dialog);
        field.fill = [slider, number](const ExportRequest& request) { slider->setValue(number->read(request)); };
        field.put = [slider, number](ExportRequest& request) { number->write(request, slider->value()); };
        field.widget = slider;
        form.addRow(slider);
        return field; // Label and hint are its own.
    }
    if (const auto* number = std::get_if<model::ExportNumber>(&option.kind)) {
        std::vector<int> values;
        for (int value = static_cast<int>(number->least); value <= static_cast<int>(number->greatest); ++value)
            values.push_back(value);
        QComboBox* box = numberList(values, QStringLiteral("%1"), dialog);
        field.fill = [box, number](const ExportRequest& request) {
            box->setCurrentIndex(box->findData(static_cast<int>(std::lround(number->read(request)))));
        };
        field.put = [box, number](ExportRequest& request) { number->write(request, box->currentData().toInt()); };
        field.widget = box;
    } else if (const auto* choice = std::get_if<model::ExportChoice>(&option.kind)) {
        QComboBox* box = numberList(choice->values, QCoreApplication::translate("Export", choice->text), dialog);
        field.fill = [box, choice](const ExportRequest& request) {
            box->setCurrentIndex(box->findData(request.cards.*choice->field));
        };
        field.put = [box, choice](ExportRequest& request) {
            request.cards.*choice->field = box->currentData().toInt();
        };
        field.widget = box;
    } else if (const auto* one = std::get_if<model::ExportSwitch>(&option.kind)) {
        auto* box = new QCheckBox(option.labelText(), &dialog);
        field.fill = [box, one](const ExportRequest& request) { box->setChecked(request.cards.*one->field); };
        field.put = [box, one](ExportRequest& request) { request.cards.*one->field = box->isChecked(); };
        field.widget = box;
    } else if (const auto* text = std::get_if<model::ExportText>(&option.kind)) {
        auto* line = new QLineEdit(&dialog);
        line->setMaxLength(text->longest);
        line->setPlaceholderText(QCoreApplication::translate("Export", text->whenEmpty));
        field.fill = [line, text](const ExportRequest& request) { line->setText(request.*text->field); };
        field.put = [line, text](ExportRequest& request) { request.*text->field = line->text(); };
        field.widget = line;
    }
    if (*option.hint != '\0')
        field.widget->setToolTip(option.hintText());
    form.addRow(std::holds_alternative<model::ExportSwitch>(option.kind) ? QString() : option.labelText(),
                field.widget);
    return field;
}

void ExportOptionFields::showFor(const model::ExportFormat& format)
{
    for (const Field& field : m_fields)
        m_form.setRowVisible(field.widget, std::ranges::find(format.options, field.option) != format.options.end());
}

void ExportOptionFields::fill(const ExportRequest& request)
{
    for (const Field& field : m_fields)
        field.fill(request);
}

void ExportOptionFields::put(ExportRequest& request) const
{
    for (const Field& field : m_fields) {
        if (std::ranges::find(request.format->unasked, field.option) != request.format->unasked.end())
            field.option->reset(request);
        else
            field.put(request);
    }
}

} // namespace hairpaint::view
