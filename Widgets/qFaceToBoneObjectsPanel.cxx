#include "qFaceToBoneObjectsPanel.h"

#include "qFaceToBoneObjects.h"
#include "qFaceToBoneToolTip.h"

#include <QColorDialog>
#include <QHeaderView>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QTreeWidget>
#include <QVBoxLayout>

qFaceToBoneObjectsPanel::qFaceToBoneObjectsPanel(qFaceToBoneObjects* objects, QWidget* parent)
    : QWidget(parent), m_objects(objects), m_tree(new QTreeWidget)
{
  m_tree->setColumnCount(4);
  m_tree->setHeaderLabels({tr("Object"), tr("Colour"), tr("Opacity"), QString()});
  m_tree->setRootIsDecorated(false);
  m_tree->header()->setStretchLastSection(false);
  m_tree->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  m_tree->header()->resizeSection(1, 52);
  m_tree->header()->resizeSection(2, 90);
  m_tree->header()->setMinimumSectionSize(24);
  m_tree->header()->resizeSection(3, 26);
  m_tree->setSelectionMode(QAbstractItemView::NoSelection);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_tree);
  connect(m_objects, &qFaceToBoneObjects::listChanged, this, &qFaceToBoneObjectsPanel::rebuild);
  connect(m_objects, &qFaceToBoneObjects::objectChanged, this,
          &qFaceToBoneObjectsPanel::updateItem);
  connect(m_tree, &QTreeWidget::itemChanged, this,
          [this](QTreeWidgetItem* item, int)
          {
            if (!m_updating)
              m_objects->setVisible(item->data(0, Qt::UserRole).toString(),
                                    item->checkState(0) == Qt::Checked);
          });
  rebuild();
}

void qFaceToBoneObjectsPanel::rebuild()
{
  m_updating = true;
  m_tree->clear();
  m_updating = false;
  for (const qFaceToBoneObject& object : m_objects->all())
    addItem(object.key);
}

void qFaceToBoneObjectsPanel::addItem(const QString& key)
{
  m_updating = true;
  auto* item = new QTreeWidgetItem(m_tree);
  item->setData(0, Qt::UserRole, key);
  auto* colour = new QPushButton;
  colour->setFixedSize(36, 18);
  colour->setToolTip(qFaceToBoneToolTip(tr("Colour of the surface"), tr("Press to choose another"),
                                        tr("diffuse colour")));
  connect(colour, &QPushButton::clicked, this,
          [this, key]
          {
            const qFaceToBoneObject* object = m_objects->find(key);
            const QColor chosen = object ? QColorDialog::getColor(object->colour, this) : QColor();
            if (chosen.isValid())
              m_objects->setColour(key, chosen);
          });
  auto* opacity = new QSlider(Qt::Horizontal);
  opacity->setRange(0, 100);
  opacity->setToolTip(
      qFaceToBoneToolTip(tr("How much of what lies behind is hidden"), tr("100 %"), tr("opacity")));
  connect(opacity, &QSlider::valueChanged, this,
          [this, key](int percent)
          {
            if (!m_updating)
              m_objects->setOpacity(key, percent / 100.0);
          });
  m_tree->setItemWidget(item, 1, colour);
  m_tree->setItemWidget(item, 2, opacity);
  if (const qFaceToBoneObject* object = m_objects->find(key); object && object->removable)
  {
    auto* remove = new QPushButton(QString::fromUtf8("\xc3\x97"));
    remove->setFixedSize(20, 18);
    remove->setObjectName("remove");
    remove->setToolTip(
        qFaceToBoneToolTip(tr("Takes it off the list"), tr("A ruler"), tr("delete")));
    connect(
        remove, &QPushButton::clicked, this, [this, key] { emit m_objects->removeWanted(key); },
        Qt::QueuedConnection); // the button goes with it
    m_tree->setItemWidget(item, 3, remove);
  }
  m_updating = false;
  updateItem(key);
}

QTreeWidgetItem* qFaceToBoneObjectsPanel::itemOf(const QString& key) const
{
  for (int i = 0; i < m_tree->topLevelItemCount(); ++i)
    if (m_tree->topLevelItem(i)->data(0, Qt::UserRole).toString() == key)
      return m_tree->topLevelItem(i);
  return nullptr;
}

void qFaceToBoneObjectsPanel::updateItem(const QString& key)
{
  const qFaceToBoneObject* object = m_objects->find(key);
  QTreeWidgetItem* item = itemOf(key);
  if (!object || !item)
    return;
  m_updating = true;
  item->setText(0, object->name);
  item->setCheckState(0, object->visible ? Qt::Checked : Qt::Unchecked);
  m_tree->itemWidget(item, 1)->setStyleSheet(
      QString("background:%1;border:1px solid #777").arg(object->colour.name()));
  static_cast<QSlider*>(m_tree->itemWidget(item, 2))
      ->setValue(static_cast<int>(100 * object->opacity + 0.5));
  m_updating = false;
}
