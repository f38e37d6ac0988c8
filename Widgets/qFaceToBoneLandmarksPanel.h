#ifndef qFaceToBoneLandmarksPanel_h
#define qFaceToBoneLandmarksPanel_h

#include <QWidget>

class QLabel;
class QPushButton;
class QTreeWidget;
class qFaceToBoneCase;

/// Which landmarks are placed, which does the cut still need, and where do they go?
class qFaceToBoneLandmarksPanel : public QWidget
{
  Q_OBJECT

public:
  qFaceToBoneLandmarksPanel(qFaceToBoneCase* work, QWidget* parent = nullptr);

  QString current() const;
  void setCurrent(const QString& name);
  /// Whether the next click in the 3D view places the current landmark.
  bool isPlacing() const;
  void stopPlacing();
  /// Goes on to the next one that is not placed, those that the cut needs first.
  void advance();

signals:
  void placingChanged(bool on);
  /// The current landmark is wanted where the slices' crosshair is.
  void crosshairWanted(const QString& name);
  void currentChanged(const QString& name);

private:
  void update();
  void load();

  qFaceToBoneCase* m_case;
  QLabel* m_note;
  QTreeWidget* m_list;
  QPushButton *m_place, *m_here, *m_remove;
};

#endif
