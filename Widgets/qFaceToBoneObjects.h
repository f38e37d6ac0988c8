#ifndef qFaceToBoneObjects_h
#define qFaceToBoneObjects_h

#include <QColor>
#include <QObject>
#include <QString>

#include <vtkSmartPointer.h>

#include <array>
#include <vector>

class vtkPolyData;

/// One surface that views show [mm, RAS].
struct qFaceToBoneObject
{
  QString key;  ///< "skin", "target", "fragment/mid-face"
  QString name; ///< for people
  vtkSmartPointer<vtkPolyData> surface;
  QColor colour;
  double opacity = 1;
  bool visible = true;
  bool removable = false; ///< by the user, as a ruler is
  /// Where it has been moved, row by row; rest to moved points.
  std::array<double, 16> matrix{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  QString colourArray; ///< point array that colours it; empty: its own colour
  double range = 1;    ///< of the array's colours [mm]: 0 to range, or -range to range
  bool diverging = false;
};

/// What is there to see? The surfaces of a case in the order of a list, for all views alike.
class qFaceToBoneObjects : public QObject
{
  Q_OBJECT

public:
  explicit qFaceToBoneObjects(QObject* parent = nullptr) : QObject(parent) {}

  const std::vector<qFaceToBoneObject>& all() const { return m_objects; }
  /// Null if there is none of that key; until the next change of the list.
  const qFaceToBoneObject* find(const QString& key) const;

  /// Adds an object, or gives it another surface; how it looked is kept.
  void put(const qFaceToBoneObject& object);
  void remove(const QString& key);
  void clear();

  void setVisible(const QString& key, bool visible);
  void setOpacity(const QString& key, double opacity);
  void setColour(const QString& key, const QColor& colour);
  void setMatrix(const QString& key, const std::array<double, 16>& matrix);
  void setColouring(const QString& key, const QString& array, double range, bool diverging);

signals:
  void listChanged();
  void objectChanged(const QString& key);
  void removeWanted(const QString& key); ///< by the user

private:
  qFaceToBoneObject* of(const QString& key);

  std::vector<qFaceToBoneObject> m_objects;
};

#endif
