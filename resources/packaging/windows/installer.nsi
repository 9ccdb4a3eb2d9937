; The installer: for the user alone, without an administrator, into AppData\Local\Programs. VERSION, FOLDER, ICON and OUTPUT are the build's.
; What the program keeps for the user (settings, own styles, unsaved work) lies elsewhere in AppData, and stays when it is removed.
Target amd64-unicode ; As the program is, and as a 64-bit wine runs it.
Unicode true
ManifestDPIAware true
RequestExecutionLevel user
SetCompressor /SOLID lzma
!include "MUI2.nsh"

!define KEY "Software\Microsoft\Windows\CurrentVersion\Uninstall\HairPaint"
!define CLASSES "Software\Classes"

Name "Hair Paint"
OutFile "${OUTPUT}"
InstallDir "$LOCALAPPDATA\Programs\Hair Paint"
InstallDirRegKey HKCU "${KEY}" "InstallLocation"
!define MUI_ICON "${ICON}"
!define MUI_UNICON "${ICON}"
!insertmacro MUI_PAGE_DIRECTORY
!insertmacro MUI_PAGE_INSTFILES
!insertmacro MUI_UNPAGE_CONFIRM
!insertmacro MUI_UNPAGE_INSTFILES
!insertmacro MUI_LANGUAGE "English"
!insertmacro MUI_LANGUAGE "Spanish"

Section
    SetOutPath "$INSTDIR"
    File /r "${FOLDER}/*"
    WriteUninstaller "$INSTDIR\uninstall.exe"
    CreateShortcut "$SMPROGRAMS\Hair Paint.lnk" "$INSTDIR\hairpaint.exe"

    ; Projects open by a double click, by `hairpaint.exe FILE`.
    WriteRegStr HKCU "${CLASSES}\HairPaint.Project" "" "Hair Paint project"
    WriteRegStr HKCU "${CLASSES}\HairPaint.Project\DefaultIcon" "" "$INSTDIR\hairpaint.exe,0"
    WriteRegStr HKCU "${CLASSES}\HairPaint.Project\shell\open\command" "" '"$INSTDIR\hairpaint.exe" "%1"'
    WriteRegStr HKCU "${CLASSES}\.hairpaint" "" "HairPaint.Project"
    WriteRegStr HKCU "${CLASSES}\.hairpaint" "Content Type" "application/x-hairpaint"
    WriteRegStr HKCU "${CLASSES}\.hairpaint\OpenWithProgids" "HairPaint.Project" ""
    System::Call 'shell32::SHChangeNotify(i 0x08000000, i 0, p 0, p 0)'

    WriteRegStr HKCU "${KEY}" "DisplayName" "Hair Paint"
    WriteRegStr HKCU "${KEY}" "DisplayVersion" "${VERSION}"
    WriteRegStr HKCU "${KEY}" "DisplayIcon" "$INSTDIR\hairpaint.exe,0"
    WriteRegStr HKCU "${KEY}" "Publisher" "The Hair Paint authors"
    WriteRegStr HKCU "${KEY}" "InstallLocation" "$INSTDIR"
    WriteRegStr HKCU "${KEY}" "UninstallString" '"$INSTDIR\uninstall.exe"'
    WriteRegStr HKCU "${KEY}" "QuietUninstallString" '"$INSTDIR\uninstall.exe" /S'
    WriteRegDWORD HKCU "${KEY}" "NoModify" 1
    WriteRegDWORD HKCU "${KEY}" "NoRepair" 1
SectionEnd

; Only what was installed: a folder that holds anything else stays.
Section "Uninstall"
    Delete "$SMPROGRAMS\Hair Paint.lnk"
    RMDir /r "$INSTDIR\platforms"
    RMDir /r "$INSTDIR\styles"
    RMDir /r "$INSTDIR\translations"
    RMDir /r "$INSTDIR\blender"
    Delete "$INSTDIR\*.dll"
    Delete "$INSTDIR\hairpaint.exe"
    Delete "$INSTDIR\hairpaint.com"
    Delete "$INSTDIR\hairpaint-import.exe"
    Delete "$INSTDIR\LICENSE.txt"
    Delete "$INSTDIR\uninstall.exe"
    RMDir "$INSTDIR"
    DeleteRegKey HKCU "${CLASSES}\HairPaint.Project"
    DeleteRegValue HKCU "${CLASSES}\.hairpaint\OpenWithProgids" "HairPaint.Project"
    ReadRegStr $0 HKCU "${CLASSES}\.hairpaint" ""
    StrCmp $0 "HairPaint.Project" 0 +2
    DeleteRegKey HKCU "${CLASSES}\.hairpaint"
    DeleteRegKey HKCU "${KEY}"
    System::Call 'shell32::SHChangeNotify(i 0x08000000, i 0, p 0, p 0)'
SectionEnd
