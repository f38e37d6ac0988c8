#ifndef qFaceToBoneCutsPanel_h
#define qFaceToBoneCutsPanel_h

#include <QWidget>

class QCheckBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QSlider;
class QToolButton;
class QTreeWidget;
class QTreeWidgetItem;
class qFaceToBoneCase;

/// Where is the bone cut, how wide and how deep, and how finely is the tissue meshed?
class qFaceToBoneCutsPanel : public QWidget
{
  Q_OBJECT

public:
  qFaceToBoneCutsPanel(qFaceToBoneCase* work, QWidget* parent = nullptr);

  bool showsTools() const;
  /// A line is being drawn, or no more.
  void setDrawing(bool on);

signals:
  void toolsShown(bool on);
  /// A plane is wanted where the crosshair is: a cut of its own, or one more of the current cut.
  void planeWanted(bool ofCurrent);
  void lineWanted(bool ofCurrent);
  void lineFinished();
  void lineDropped();
  /// Fragments are to be drawn apart by so much [mm].
  void explodeChanged(double mm);
  void refused(const QString& why);

private:
  QWidget* makeCutButtons();
  QWidget* makeDrawingBox();
  void makeNumbers(QFormLayout* form);
  void connectParts();
  void update();
  void updateCuts();
  void updateNumbers();
  void removeChosen();
  void renamed(QTreeWidgetItem* item);

  qFaceToBoneCase* m_case;
  QTreeWidget* m_cuts;
  QToolButton *m_add, *m_remove, *m_anew, *m_undo, *m_redo;
  QCheckBox* m_tools;
  QWidget* m_drawing = nullptr;
  QDoubleSpinBox *m_kerf, *m_depth, *m_overrun, *m_density;
  QSlider* m_explode;
  QLabel* m_fragments;
  bool m_updating = false;
};

#endif
