#ifndef qFaceToBoneObjectsPanel_h
#define qFaceToBoneObjectsPanel_h

#include <QWidget>

class QTreeWidget;
class QTreeWidgetItem;
class qFaceToBoneObjects;

/// Which surfaces are shown, in which colour, and how opaque?
class qFaceToBoneObjectsPanel : public QWidget
{
  Q_OBJECT

public:
  qFaceToBoneObjectsPanel(qFaceToBoneObjects* objects, QWidget* parent = nullptr);

private:
  void rebuild();
  void updateItem(const QString& key);
  void addItem(const QString& key);
  QTreeWidgetItem* itemOf(const QString& key) const;

  qFaceToBoneObjects* m_objects;
  QTreeWidget* m_tree;
  bool m_updating = false;
};

#endif
