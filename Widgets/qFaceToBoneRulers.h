#ifndef qFaceToBoneRulers_h
#define qFaceToBoneRulers_h

#include <QObject>
#include <QString>

#include <array>
#include <string>
#include <vector>

class qFaceToBoneObjects;

/// What has the surgeon measured by hand? Distances of two points and angles of three.
///
/// Each is an object of the list ("ruler/1"); all are kept as Slicer markups in one file.
class qFaceToBoneRulers : public QObject
{
  Q_OBJECT

public:
  using Point = std::array<double, 3>; ///< [mm, RAS]
  struct Ruler
  {
    QString key;
    std::vector<Point> points; ///< 2: a distance; 3: the angle at the second
  };

  qFaceToBoneRulers(qFaceToBoneObjects* objects, QObject* parent);

  const std::vector<Ruler>& all() const { return m_rulers; }
  QString add(const std::vector<Point>& points);
  /// Takes effect in the file with `keep`.
  void setPoints(const QString& key, const std::vector<Point>& points);
  bool remove(const QString& key);
  /// Throws f2b::Error where the file cannot be written.
  void keep() const;
  /// Forgets all, and takes those of a file where it is there.
  void load(const std::string& file);

signals:
  void changed();

private:
  void show(const Ruler& ruler);

  qFaceToBoneObjects* m_objects;
  std::vector<Ruler> m_rulers;
  std::string m_file;
  int m_next = 1;
};

#endif
