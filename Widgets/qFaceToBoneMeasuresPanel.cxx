#include "qFaceToBoneMeasuresPanel.h"

#include "qFaceToBoneCase.h"
#include "qFaceToBoneToolTip.h"

#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

qFaceToBoneMeasuresPanel::qFaceToBoneMeasuresPanel(qFaceToBoneCase* work, QWidget* parent)
    : QWidget(parent), m_case(work), m_table(new QTableWidget(0, 3)), m_note(new QLabel),
      m_distance(new QPushButton(tr("Distance"))), m_angle(new QPushButton(tr("Angle")))
{
  m_distance->setObjectName("distance");
  m_angle->setObjectName("angle");
  m_distance->setToolTip(qFaceToBoneToolTip(tr("Click two points on skin or bone in the 3D view"),
                                            tr("Kept under Objects; its points can be dragged"),
                                            tr("ruler")));
  m_angle->setToolTip(qFaceToBoneToolTip(tr("Click three points; the second is the corner"),
                                         tr("Kept under Objects; its points can be dragged"),
                                         tr("angle of three points")));
  auto* rulers = new QHBoxLayout;
  rulers->addWidget(new QLabel(tr("Measure by hand")), 1);
  for (QPushButton* button : {m_distance, m_angle})
  {
    button->setCheckable(true);
    rulers->addWidget(button);
    connect(button, &QPushButton::clicked, this,
            [this, button](bool on)
            {
              (button == m_distance ? m_angle : m_distance)->setChecked(false);
              emit rulerWanted(!on ? 0 : button == m_distance ? 2 : 3);
            });
  }
  m_table->setHorizontalHeaderLabels({tr("Measure"), tr("Before"), tr("Planned")});
  m_table->verticalHeader()->hide();
  m_table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  m_table->horizontalHeader()->resizeSection(1, 76);
  m_table->horizontalHeader()->resizeSection(2, 76);
  m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  m_table->setSelectionMode(QAbstractItemView::NoSelection);
  m_note->setWordWrap(true);
  m_note->setMargin(4);
  auto* parts = new QVBoxLayout(this);
  parts->setContentsMargins(0, 0, 0, 0);
  parts->addLayout(rulers);
  parts->addWidget(m_note);
  parts->addWidget(m_table, 1);
  connect(m_case, &qFaceToBoneCase::planChanged, this, &qFaceToBoneMeasuresPanel::update);
  connect(m_case, &qFaceToBoneCase::loaded, this, &qFaceToBoneMeasuresPanel::update);
  connect(m_case, &qFaceToBoneCase::landmarksChanged, this, &qFaceToBoneMeasuresPanel::update);
  update();
}

void qFaceToBoneMeasuresPanel::rulerPlaced()
{
  m_distance->setChecked(false);
  m_angle->setChecked(false);
  emit rulerWanted(0);
}

void qFaceToBoneMeasuresPanel::showEvent(QShowEvent* event)
{
  QWidget::showEvent(event);
  update();
}

void qFaceToBoneMeasuresPanel::update()
{
  if (!isVisible()) // it changes with every move of the brush
    return;
  const auto measures = m_case->measures();
  m_note->setText(measures.empty() ? tr("Measures need landmarks: N, Or_R and Or_L at least.")
                                   : tr("No norms: they depend on age, sex and population."));
  m_table->setRowCount(static_cast<int>(measures.size()));
  for (int row = 0; row < m_table->rowCount(); ++row)
  {
    const qFaceToBoneCase::Measure& m = measures[static_cast<std::size_t>(row)];
    const QString unit = m.unit == "deg" ? QString::fromUtf8("\xc2\xb0") : " " + m.unit;
    const QString texts[] = {m.name, QString::number(m.before, 'f', 1) + unit,
                             QString::number(m.planned, 'f', 1) + unit};
    for (int column = 0; column < 3; ++column)
    {
      auto* item = new QTableWidgetItem(texts[column]);
      item->setToolTip(qFaceToBoneToolTip(m.name, m.definition, tr("cephalometric measure")));
      if (column > 0)
        item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      m_table->setItem(row, column, item);
    }
  }
}
