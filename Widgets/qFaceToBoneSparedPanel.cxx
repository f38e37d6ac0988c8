#include "qFaceToBoneSparedPanel.h"

#include "qFaceToBoneCase.h"
#include "qFaceToBoneToolTip.h"

#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTreeWidget>

qFaceToBoneSparedPanel::qFaceToBoneSparedPanel(qFaceToBoneCase* work, QWidget* parent)
    : QGroupBox(tr("To be spared"), parent), m_case(work), m_list(new QTreeWidget),
      m_margin(new QDoubleSpinBox)
{
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  m_list->setObjectName("spared");
  m_list->setHeaderLabels({tr("Structure"), tr("Nearest cut")});
  m_list->setFixedHeight(84);
  m_list->setRootIsDecorated(false);
  m_list->header()->resizeSection(0, 125);
  m_list->setToolTip(qFaceToBoneToolTip(tr("How near the cuts come to what they should spare"),
                                        tr("Red: within the margin"),
                                        tr("distance from the kerf's wall")));
  auto* import = new QPushButton(tr("Import..."));
  auto* remove = new QPushButton(tr("Remove"));
  import->setObjectName("importSpared");
  remove->setObjectName("removeSpared");
  import->setToolTip(qFaceToBoneToolTip(tr("A nerve (Slicer curve) or tooth roots (a model)"),
                                        tr("nerve_right.mrk.json, roots.vtp"),
                                        tr("protected structure")));
  remove->setToolTip(qFaceToBoneToolTip(tr("The chosen structure need not be spared"),
                                        tr("Undo brings it back"), tr("delete")));
  m_margin->setObjectName("margin");
  m_margin->setRange(0, 50);
  m_margin->setDecimals(1);
  m_margin->setSuffix(" mm");
  m_margin->setToolTip(qFaceToBoneToolTip(tr("A cut nearer than this is warned of"), tr("2 mm"),
                                          tr("safety margin of the chosen structure")));
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(4, 4, 4, 4);
  rows->addWidget(m_list);
  auto* row = new QHBoxLayout;
  row->addWidget(import);
  row->addWidget(remove);
  row->addWidget(m_margin);
  rows->addLayout(row);
  connect(import, &QPushButton::clicked, this, &qFaceToBoneSparedPanel::choose);
  connect(remove, &QPushButton::clicked, this, [this] { m_case->cuts()->removeSpared(chosen()); });
  connect(m_margin, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          [this](double mm) { m_case->cuts()->setMargin(chosen(), mm); });
  connect(m_list, &QTreeWidget::currentItemChanged, this, [this] { updateMargin(); });
  connect(m_case->cuts(), &qFaceToBoneCuts::changed, this, &qFaceToBoneSparedPanel::update);
  update();
}

int qFaceToBoneSparedPanel::chosen() const
{
  return m_list->indexOfTopLevelItem(m_list->currentItem());
}

void qFaceToBoneSparedPanel::choose()
{
  const QString file = QFileDialog::getOpenFileName(
      this, tr("A structure to be spared"), m_case->folder(),
      tr("Curves and surfaces (*.mrk.json *.vtp *.ply *.obj *.stl *.vtk)"));
  if (!file.isEmpty())
    import(file);
}

bool qFaceToBoneSparedPanel::import(const QString& file)
{
  if (m_case->cuts()->addSpared(file))
    return true;
  emit refused(m_case->cuts()->error());
  return false;
}

void qFaceToBoneSparedPanel::updateMargin()
{
  const QSignalBlocker blocker(m_margin);
  const auto& all = m_case->cuts()->clearances();
  const auto index = static_cast<std::size_t>(chosen()); // none: beyond all
  m_margin->setEnabled(index < all.size());
  if (index < all.size())
    m_margin->setValue(all[index].margin);
}

void qFaceToBoneSparedPanel::update()
{
  const auto& all = m_case->cuts()->clearances();
  while (m_list->topLevelItemCount() > static_cast<int>(all.size()))
    delete m_list->topLevelItem(m_list->topLevelItemCount() - 1);
  for (int k = 0; k < static_cast<int>(all.size()); ++k)
  {
    const qFaceToBoneCuts::Clearance& c = all[static_cast<std::size_t>(k)];
    QTreeWidgetItem* item = m_list->topLevelItem(k);
    if (!item)
      item = new QTreeWidgetItem(m_list);
    item->setText(0, c.name);
    item->setText(1, c.words);
    item->setToolTip(1, c.words);
    QPixmap swatch(12, 12);
    swatch.fill(qFaceToBoneCuts::colourOfSpared(c.near));
    item->setIcon(0, swatch);
    const QBrush colour(c.near ? QColor(190, 15, 20) : palette().color(QPalette::Text));
    for (int column = 0; column < 2; ++column)
      item->setForeground(column, colour);
  }
  if (!all.empty() && !m_list->currentItem())
    m_list->setCurrentItem(m_list->topLevelItem(0));
  updateMargin();
}
